// SPDX-License-Identifier: BSD-3-Clause
// Objects whose maps have any shape that a library file allows, and a search for them.
#pragma once

#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "mbncc/matching/matcher.hpp"

namespace mbncc::test {

enum class MapShape { kFull, kLine, kDiagonal, kFrame, kPixel, kScattered, kDisc };
constexpr int kMapShapes = 7;

/// The border of its learning image at which an object lies.
enum class Border { kNone, kLeft, kTop, kRight, kBottom };
constexpr int kBorders = 5;

/// A map of `size` whose bounding box has the same size.
inline cv::Mat map_of(MapShape shape, cv::Size size, unsigned seed) {
  cv::Mat map = cv::Mat::zeros(size, CV_8UC1);
  const cv::Point last(size.width - 1, size.height - 1);
  switch (shape) {
    case MapShape::kFull:
      map.setTo(255);
      break;
    case MapShape::kLine:
      cv::line(map, {0, last.y / 2}, {last.x, last.y / 2}, 255);
      break;
    case MapShape::kDiagonal:
      cv::line(map, {0, 0}, last, 255);
      break;
    case MapShape::kFrame:
      cv::rectangle(map, {0, 0}, last, 255);
      break;
    case MapShape::kPixel:
      map.at<uchar>(last / 2) = 255;
      break;
    case MapShape::kScattered:
      cv::RNG(seed).fill(map, cv::RNG::UNIFORM, 0, 2);
      map = map > 0;
      map.at<uchar>(last) = 255;
      break;
    case MapShape::kDisc:
      cv::ellipse(map, last / 2, {size.width / 2, size.height / 2}, 0, 0, 360, 255, -1);
      break;
  }
  return map;
}

/// An object with that map and `margin` [px] of background in its crop, learned at a border of an
/// image that leaves `room` [px] on the other sides.
inline std::shared_ptr<ObjectModel> object_of(const cv::Mat& map, Border border, int margin,
                                              int room, unsigned seed) {
  View view;
  cv::copyMakeBorder(map, view.map, margin, margin, margin, margin, cv::BORDER_CONSTANT, {0});
  view.template_image.create(view.map.size(), CV_8UC3);
  cv::RNG(seed).fill(view.template_image, cv::RNG::UNIFORM, 0, 256);
  view.origin = {border == Border::kLeft ? 0 : room, border == Border::kTop ? 0 : room};
  view.image_size = view.map.size() + cv::Size(view.origin);
  if (border != Border::kRight) view.image_size.width += room;
  if (border != Border::kBottom) view.image_size.height += room;
  view.reference = {view.origin.x + 0.5 * view.map.cols, view.origin.y + 0.5 * view.map.rows, 0.3};
  auto model = std::make_shared<ObjectModel>();
  model->name = model->label = "object";
  model->views = {view};
  return model;
}

/// A noise image of `size` that contains the part of the object's crop that fits at a border.
inline cv::Mat image_of(const View& view, cv::Size size, Border border, unsigned seed) {
  cv::Mat image(size, CV_8UC3);
  cv::RNG(seed + 1).fill(image, cv::RNG::UNIFORM, 60, 200);
  cv::Point corner((size.width - view.map.cols) / 2, (size.height - view.map.rows) / 2);
  if (border == Border::kLeft) corner.x = 0;
  if (border == Border::kTop) corner.y = 0;
  if (border == Border::kRight) corner.x = size.width - view.map.cols;
  if (border == Border::kBottom) corner.y = size.height - view.map.rows;
  const cv::Rect shown = cv::Rect(corner, view.map.size()) & cv::Rect({0, 0}, size);
  const cv::Rect part(shown.tl() - corner, shown.size());
  if (!shown.empty()) view.template_image(part).copyTo(image(shown));
  return image;
}

/// Throws std::runtime_error if the object is not searched, or the result is implausible.
inline void check_search(const SearchConfig& config, const std::shared_ptr<ObjectModel>& model,
                         const cv::Mat& image) {
  Matcher matcher(config);
  matcher.set_objects({model});
  for (const auto& [name, reason] : matcher.unsearchable())
    throw std::runtime_error(name + ": " + reason);
  matcher.score_map(image);
  for (const std::size_t among : {std::size_t{1}, kFewObjects + 1}) {
    SearchRequest request;
    request.among = among;
    const SearchResult result = matcher.find(image, request);
    if (result.searched.size() != 1) throw std::runtime_error("the object was not searched for");
    for (const auto& match : result.matches)
      if (!std::isfinite(match.score + match.pose.x + match.pose.y + match.pose.theta))
        throw std::runtime_error("a match has no finite pose and score");
  }
}

}  // namespace mbncc::test
