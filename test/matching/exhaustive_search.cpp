// SPDX-License-Identifier: BSD-3-Clause
#include "matching/exhaustive_search.hpp"

#include <algorithm>
#include <cmath>

#include "matching/scene/grey_image.hpp"
#include "matching/template/candidate.hpp"
#include "matching/template/map_footprint.hpp"
#include "mbncc/matching/similarity.hpp"

namespace mbncc {
namespace {

/// All grid poses that reach the threshold.
std::vector<templates::Candidate> all_poses(const MaskedTemplate& points, const cv::Mat& grey,
                                            const ExhaustiveSettings& settings) {
  const int rotations = std::max(1, static_cast<int>(std::ceil(2 * kPi / settings.angle_step)));
  std::vector<templates::Candidate> poses;
  for (int k = 0; k < rotations; ++k)
    for (int y = 0; y < grey.rows; y += settings.position_step)
      for (int x = 0; x < grey.cols; x += settings.position_step) {
        const Pose2D pose{double(x), double(y), wrap_angle(2 * kPi * k / rotations)};
        const Similarity found = similarity(points, grey, pose);
        if (found.value >= settings.min_similarity && found.visible >= settings.min_visible)
          poses.push_back({pose, 0, found.value});
      }
  templates::sort_by_value(poses);
  return poses;
}

std::vector<templates::Candidate> without_overlaps(const std::vector<templates::Candidate>& poses,
                                                   const templates::MapFootprint& shape,
                                                   const ExhaustiveSettings& settings) {
  std::vector<templates::Candidate> kept;
  for (const auto& pose : poses) {
    if (static_cast<int>(kept.size()) >= settings.max_instances) break;
    const bool covered =
        std::any_of(kept.begin(), kept.end(), [&](const templates::Candidate& better) {
          return templates::overlap(shape, pose.pose, shape, better.pose) > settings.max_overlap;
        });
    if (!covered) kept.push_back(pose);
  }
  return kept;
}

}  // namespace

std::vector<Match> find_exhaustively(const ObjectModel& object, const cv::Mat& image,
                                     const ExhaustiveSettings& settings) {
  validate(object);
  const View& view = object.views.front();
  const cv::Mat searched = scene::grey_image(image);
  const cv::Mat learned = scene::grey_image(view.template_image);
  const cv::Point2d anchor = excircle(view.map).centre;
  const templates::MapFootprint shape(view.map, anchor);
  const auto poses = all_poses(masked_template(learned, view.map, anchor), searched, settings);
  const Pose2D reference{view.reference.x - view.origin.x - anchor.x,
                         view.reference.y - view.origin.y - anchor.y, view.reference.theta};
  std::vector<Match> matches;
  for (const auto& pose : without_overlaps(poses, shape, settings)) {
    Match match;
    match.name = object.name;
    match.revision = object.revision;
    match.pose = compose(pose.pose, reference);
    match.similarity = match.score = pose.value;
    matches.push_back(match);
  }
  return matches;
}

}  // namespace mbncc
