#include "mbncc/learning/quality.hpp"

#include "learning/map_measures.hpp"
#include "learning/verdict.hpp"

namespace mbncc {

Quality assess_quality(const ObjectModel& object, const cv::Mat& before, const cv::Mat& after,
                       const std::optional<CutEvidence>& evidence, const LearningConfig& config,
                       const SearchConfig& search) {
  (void)search;
  const View& view = object.views.front();
  const cv::Mat map = full_size_map(view);
  Quality quality;
  measure_map(before, map, quality);
  if (!after.empty()) quality.change_agreement = change_agreement(before, after, map);
  decide(quality, touches_border(map), evidence, config);
  return quality;
}

}  // namespace mbncc
