#include "matching/prepared_object.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc {
namespace {

cv::Mat grey_of(const View& view) {
  cv::Mat grey;
  cv::cvtColor(view.template_image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// The map without its rim, where template pixels mix with the background; the map itself when
/// little would be left.
cv::Mat without_rim(const cv::Mat& map) {
  cv::Mat padded, inner;
  cv::copyMakeBorder(map, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::erode(padded, inner, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  inner = inner(cv::Rect({1, 1}, map.size())).clone();
  return 2 * cv::countNonZero(inner) > cv::countNonZero(map) ? inner : map;
}

Pose2D reference_in_crop(const View& view, cv::Point2d anchor) {
  return {view.reference.x - view.origin.x - anchor.x, view.reference.y - view.origin.y - anchor.y,
          view.reference.theta};
}

}  // namespace

PreparedView::PreparedView(const View& view)
    : anchor(excircle(view.map).centre),
      reference_in_anchor(reference_in_crop(view, anchor)),
      shape(view.map, anchor) {
  const cv::Mat grey = grey_of(view), inner = without_rim(view.map);
  kernels = rotated_kernels(grey, inner, anchor);
  points = masked_template(grey, view.map, anchor);
  for (int level = 0; level <= kernels.level; ++level)
    refiners.emplace_back(grey, inner, anchor, level);
  const auto all = outlines(view);
  if (!all.empty()) outline = all.front();
}

PreparedObject::PreparedObject(std::shared_ptr<const ObjectModel> object)
    : model(std::move(object)) {
  validate(*model);
  for (const auto& view : model->views) views.emplace_back(view);
}

int PreparedObject::top_level() const {
  int top = 0;
  for (const auto& view : views) top = std::max(top, view.top_level());
  return top;
}

}  // namespace mbncc
