// SPDX-License-Identifier: BSD-3-Clause
#include "learning/quality/self_search.hpp"

#include <algorithm>
#include <memory>

#include "imaging/half_size.hpp"
#include "learning/quality/lesson_search.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::quality {
namespace {

constexpr double kSamePlace = 0.25;  // part of the excircle's radius; nearer matches are the object
constexpr double kLeastSamePlace = 4;  // [px]
constexpr double kEnoughRadius = 32;   // [px] larger objects are searched at half the size

// The search reports the best candidate even with a low score.
SearchRequest anything() {
  SearchRequest request;
  request.min_score = 0;
  request.max_instances = 5;
  return request;
}

// An object's only view and its learning image, reduced to the size that is needed.
struct Reduced {
  cv::Mat image;
  View view;
  double scale = 1;  // relative to the learned view
};

Reduced reduced(const View& view, const cv::Mat& image) {
  Reduced result{image, view, 1};
  while (excircle(result.view.map).radius >= 2 * kEnoughRadius) {
    const cv::Mat map = imaging::half_size(full_size_map(result.view), cv::INTER_AREA) > 127;
    if (cv::countNonZero(map) == 0) break;
    result.scale /= 2;
    result.image = imaging::half_size(result.image, cv::INTER_AREA);
    const Pose2D& reference = result.view.reference;
    result.view = crop_view(result.image, map,
                            {(reference.x - 0.5) / 2, (reference.y - 0.5) / 2, reference.theta});
  }
  return result;
}

}  // namespace

void search_itself(const ObjectModel& object, const cv::Mat& image, const SearchConfig& search,
                   Quality& quality) {
  // The verdict must not depend on other objects: only this one is searched for.
  const auto searched = with_central_reference(object);
  const Reduced small = reduced(searched->views.front(), image);
  searched->views = {small.view};
  Matcher matcher(without_time_budget(search));
  matcher.set_objects({searched}, true);
  const SearchResult found = matcher.find(small.image, anything());
  const double near = std::max(kLeastSamePlace, kSamePlace * excircle(small.view.map).radius);
  for (const Match& match : found.matches) {
    const double distance = cv::norm(match.pose.position() - small.view.reference.position());
    if (distance > near) {
      quality.runner_up = std::max(quality.runner_up, match.score);
    } else if (match.score > quality.self_score) {
      quality.self_score = match.score;
      quality.self_error = distance / small.scale;
    }
  }
  quality.search_time = found.search_time;
}

}  // namespace mbncc::quality
