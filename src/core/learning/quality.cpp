#include "mbncc/learning/quality.hpp"

#include "learning/map_measures.hpp"
#include "learning/rotation_profile.hpp"
#include "learning/self_search.hpp"
#include "learning/verdict.hpp"

namespace mbncc {

Quality assess_quality(const ObjectModel& object, const cv::Mat& before, const cv::Mat& changed,
                       const std::optional<CutEvidence>& evidence, const LearningConfig& config,
                       const SearchConfig& search) {
  const View& view = object.views.front();
  const cv::Rect around = surroundings(view);
  const cv::Mat map = map_within(view, around);
  Quality quality;
  measure_map(before(around), map, quality);
  if (!changed.empty()) quality.change_agreement = change_agreement(changed(around), map);
  search_itself(object, before, search, quality);
  const RotationProfile profile(view, before);
  quality.angle_halfwidth = profile.fall_to((quality.self_score + quality.runner_up) / 2);
  quality.symmetry = profile.symmetry();
  decide(quality, touches_border(map), evidence, config, search);
  return quality;
}

}  // namespace mbncc
