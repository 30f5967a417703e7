// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/quality.hpp"

#include <algorithm>

#include "learning/quality/detached_part.hpp"
#include "learning/quality/rotation_profile.hpp"
#include "learning/quality/self_search.hpp"
#include "learning/quality/verdict.hpp"
#include "learning/segmentation/map_measures.hpp"
#include "mbncc/matching/symmetry.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc {
namespace {

// Sets the measured symmetry, so that the search does not measure it again.
ObjectModel with_known_symmetry(ObjectModel object, int symmetry) {
  if (is_declarable_symmetry(symmetry)) object.symmetry = symmetry;
  return object;
}

// A near symmetry is reported but not used; it is not a fault, and the operator decides.
void propose(int symmetry, Quality& quality) {
  if (symmetry == 0) {
    quality.reasons.push_back("nearly_round");
    quality.advice.push_back(
        "The outline is nearly round: declare symmetry round if the grasp works at any angle.");
    return;
  }
  const std::string degrees = std::to_string(360 / symmetry);
  quality.reasons.push_back("nearly_symmetric_" + degrees);
  quality.advice.push_back("The object looks almost the same after a turn by " + degrees +
                           " degrees: declare symmetry " + symmetry_text(symmetry) +
                           " if the grasp works at either angle.");
}

// No cut has removed specks from a given map. The operator knows whether the part belongs to it.
void doubt(const quality::DetachedPart& part, Quality& quality) {
  const bool is_worst = quality.verdict == Verdict::kGood;
  const auto at = is_worst ? 0 : static_cast<std::ptrdiff_t>(quality.reasons.size());
  quality.verdict = std::max(quality.verdict, Verdict::kMarginal);
  quality.reasons.insert(quality.reasons.begin() + at, "detached_part");
  quality.advice.insert(quality.advice.begin() + at,
                        "A separate part of " + std::to_string(part.area) + " px at x " +
                            std::to_string(part.centre.x) + ", y " + std::to_string(part.centre.y) +
                            " enlarges the object and moves its reference point: remove it from "
                            "the map, unless it belongs to the object.");
}

}  // namespace

Quality assess_quality(const ObjectModel& object, const cv::Mat& before, const cv::Mat& changed,
                       const std::optional<CutEvidence>& evidence, const LearningConfig& config,
                       const SearchConfig& search) {
  const View& view = object.views.front();
  const cv::Rect around = segmentation::surroundings(view);
  const cv::Mat map = map_within(view, around);
  Quality quality;
  segmentation::measure_map(before(around), map, quality);
  if (!changed.empty())
    quality.change_agreement = segmentation::change_agreement(changed(around), map);
  const MeasuredSymmetry measured = measure_symmetry(view);
  quality.symmetry = object.symmetry.value_or(measured.certain);
  quality::search_itself(with_known_symmetry(object, quality.symmetry), before, search, quality);
  const quality::RotationProfile profile(view, before);
  quality.angle_halfwidth = profile.fall_to((quality.self_score + quality.runner_up) / 2);
  quality::decide(quality, segmentation::touches_border(map), evidence, config, search);
  if (const auto part = evidence ? std::nullopt : quality::detached_part(map))
    doubt({part->area, part->centre + around.tl()}, quality);
  if (!object.symmetry && measured.possible != measured.certain)
    propose(measured.possible, quality);
  return quality;
}

}  // namespace mbncc
