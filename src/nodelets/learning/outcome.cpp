// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/outcome.hpp"

#include "mbncc/drawing.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"

namespace mbncc::nodelets {

using mbncc_vision::LearnObjectResult;

LearnObjectResult outcome(const Refusal& refusal) {
  LearnObjectResult result;
  result.error_code = static_cast<std::int16_t>(refusal.error);
  result.message = refusal.message;
  result.hint = refusal.hint;
  return result;
}

LearnObjectResult outcome(LearnError error, const std::string& message, const std::string& hint) {
  return outcome(Refusal(error, message, hint));
}

LearnObjectResult outcome(const LearnResult& learned, const LessonImage& image) {
  const LearnObjectResult result = outcome(learned.error, learned.message, learned.hint);
  return learned.has_model ? with_object(result, learned.object, image) : result;
}

LearnObjectResult with_object(LearnObjectResult result, const ObjectModel& model,
                              const LessonImage& image) {
  const View& view = model.views.back();
  result.object = to_msg(model, true);
  result.map = encode_image(view.map);
  result.template_image = encode_image(view.template_image);
  result.preview = encode_image(preview_of(model, image.image), image.header);
  return result;
}

cv::Mat preview_of(const ObjectModel& model, const cv::Mat& image) {
  const std::string caption = model.name + " " + to_string(model.quality.verdict);
  return draw_markings(image, {marking_of(model.views.back(), model.quality, caption)});
}

}  // namespace mbncc::nodelets
