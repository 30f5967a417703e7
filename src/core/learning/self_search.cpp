#include "learning/self_search.hpp"

#include <algorithm>
#include <memory>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

constexpr double kSamePlace = 0.25;    // of the excircle's radius: nearer is the object itself
constexpr double kLeastSamePlace = 4;  // [px]

// The search is asked for whatever is best, however bad.
SearchRequest anything() {
  SearchRequest request;
  request.min_score = 0;
  request.max_instances = 5;
  return request;
}

// The verdict must not depend on who else is searched for, nor on an impatient budget.
SearchConfig unhurried(SearchConfig search) {
  search.time_budget = 0;
  return search;
}

}  // namespace

void search_itself(const ObjectModel& object, const cv::Mat& picture, const SearchConfig& search,
                   Quality& quality) {
  Matcher matcher(unhurried(search));
  matcher.set_objects({std::make_shared<const ObjectModel>(object)});
  const SearchResult found = matcher.find(picture, anything());
  const View& view = object.views.front();
  const double near = std::max(kLeastSamePlace, kSamePlace * excircle(view.map).radius);
  for (const Match& match : found.matches) {
    const double distance = cv::norm(match.pose.position() - view.reference.position());
    if (distance > near) {
      quality.runner_up = std::max(quality.runner_up, match.score);
    } else if (match.score > quality.self_score) {
      quality.self_score = match.score;
      quality.self_error = distance;
    }
  }
  quality.search_time = found.search_time;
}

}  // namespace mbncc
