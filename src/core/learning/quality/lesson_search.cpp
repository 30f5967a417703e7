// SPDX-License-Identifier: BSD-3-Clause
#include "learning/quality/lesson_search.hpp"

namespace mbncc::quality {

SearchConfig without_time_budget(SearchConfig search) {
  search.time_budget = 0;
  return search;
}

std::shared_ptr<ObjectModel> with_central_reference(const ObjectModel& object) {
  auto copy = std::make_shared<ObjectModel>(object);
  copy->grasp.reset();
  const View& view = copy->views.front();
  const cv::Point2d centre = centroid(view.map) + cv::Point2d(view.origin);
  move_reference(*copy, {centre.x, centre.y, view.reference.theta});
  return copy;
}

}  // namespace mbncc::quality
