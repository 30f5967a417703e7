// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/object_model.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "mbncc/image_limits.hpp"
#include "mbncc/label.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc {
namespace {

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void require(bool condition, const char* fault) {
  if (!condition) throw std::invalid_argument(fault);
}

bool is_finite(const Pose2D& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}

bool is_sound(const Grasp& grasp) {
  double square = 0, norm = 0;
  for (const double value : grasp.position) square += value * value;
  for (const double value : grasp.orientation) norm += value * value;
  return std::sqrt(square) <= kLongestLength && std::abs(norm - 1) < 1e-3;  // false for NaN
}

bool is_near(const Pose2D& reference) {
  return std::max(std::abs(reference.x), std::abs(reference.y)) <= kFarthestReference;
}

bool is_printable(const Quality& quality) {
  const auto all = [](const std::vector<std::string>& texts) {
    return std::all_of(texts.begin(), texts.end(),
                       [](const std::string& text) { return mbncc::is_printable(text); });
  };
  return all(quality.reasons) && all(quality.advice);
}

/// The grasp relative to a frame that lies at `frame` [px] in the old frame and is rotated about z.
Grasp seen_from(const Grasp& grasp, const Pose2D& frame, double metres_per_pixel) {
  const cv::Point2d way(grasp.position[0] - metres_per_pixel * frame.x,
                        grasp.position[1] - metres_per_pixel * frame.y);
  const cv::Point2d place = rotate(way, -frame.theta);
  const double c = std::cos(frame.theta / 2), s = -std::sin(frame.theta / 2);
  const auto& q = grasp.orientation;
  return {{{place.x, place.y, grasp.position[2]}},
          {{c * q[0] - s * q[1], c * q[1] + s * q[0], c * q[2] + s * q[3], c * q[3] - s * q[2]}}};
}

void validate_view(const View& view) {
  require(view.template_image.type() == CV_8UC3 && !view.template_image.empty(),
          "a view's template must be a non-empty 8-bit colour image");
  require(is_binary_map(view.map) && view.map.size() == view.template_image.size(),
          "a view's map must be binary and of its template's size");
  require(cv::countNonZero(view.map) > 0, "a view's map is empty");
  require(ImageLimits::hold(view.image_size),
          "a view's learning image has at most 16384 pixels a side, 64 million in all");
  const cv::Rect crop(view.origin, view.map.size());
  require((crop & cv::Rect({0, 0}, view.image_size)) == crop,
          "a view's crop must lie in its learning image");
  require(is_finite(view.reference) && is_near(view.reference),
          "a view's reference must be finite and within 131072 pixels");
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return "GOOD";
    case Verdict::kMarginal:
      return "MARGINAL";
    case Verdict::kBad:
      return "BAD";
  }
  return "BAD";
}

bool is_valid_name(const std::string& name) {
  if (name.empty() || name.size() > 64 || !is_letter(name.front())) return false;
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

View crop_view(const cv::Mat& image, const cv::Mat& map, const Pose2D& reference, int margin) {
  require(image.type() == CV_8UC3 && image.size() == map.size() && is_binary_map(map),
          "crop_view needs a colour image and a binary map of the same size");
  const Circle circle = excircle(map);
  const double reach = circle.radius + margin;
  const cv::Point low(static_cast<int>(std::floor(circle.centre.x - reach)),
                      static_cast<int>(std::floor(circle.centre.y - reach)));
  const int side = static_cast<int>(std::ceil(2 * reach)) + 2;
  const cv::Rect crop = cv::Rect(low, cv::Size(side, side)) & cv::Rect({0, 0}, map.size());
  return {image(crop).clone(), map(crop).clone(), crop.tl(), image.size(), reference};
}

cv::Mat full_size_map(const View& view) {
  return map_within(view, {{0, 0}, view.image_size});
}

cv::Mat map_within(const View& view, const cv::Rect& part) {
  cv::Mat map = cv::Mat::zeros(part.size(), CV_8UC1);
  const cv::Rect common = part & cv::Rect(view.origin, view.map.size());
  if (!common.empty()) view.map(common - view.origin).copyTo(map(common - part.tl()));
  return map;
}

std::vector<std::vector<cv::Point2f>> outlines(const View& view) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(view.map.clone(), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE,
                   view.origin);
  std::sort(contours.begin(), contours.end(),
            [](const auto& a, const auto& b) { return cv::contourArea(a) > cv::contourArea(b); });
  const Pose2D to_object = inverse(view.reference);
  std::vector<std::vector<cv::Point2f>> result;
  for (const auto& contour : contours) {
    auto& outline = result.emplace_back();
    for (const auto& point : contour)
      outline.emplace_back(transform(to_object, cv::Point2d(point)));
  }
  return result;
}

void move_reference(ObjectModel& model, const Pose2D& reference) {
  require(is_finite(reference), "the new reference must be finite");
  require(
      !model.grasp || model.metres_per_pixel > 0,
      "the object has a grasp, but the scale needed to move it is unknown; clear the grasp first");
  require(!model.views.empty(), "an object needs at least one view");
  const Pose2D move = compose(inverse(model.views.front().reference), reference);
  for (auto& view : model.views) view.reference = compose(view.reference, move);
  if (model.grasp) model.grasp = seen_from(*model.grasp, move, model.metres_per_pixel);
}

void validate(const ObjectModel& model) {
  require(
      is_valid_name(model.name),
      "an object's name is a letter, then letters, digits or underscores, 64 characters at most");
  require(is_valid_label(model.label),
          "an object's label must be printable UTF-8 of at most 200 bytes");
  require(is_valid_label(model.taught_by),
          "the name of an object's cell must be printable UTF-8 of at most 200 bytes");
  require(is_printable(model.quality), "a lesson's reasons and advice must be printable UTF-8");
  require(model.quality.confusable_with.empty() || is_valid_name(model.quality.confusable_with),
          "what an object is confusable with must be an object's name");
  require(!model.views.empty(), "an object needs at least one view");
  require(model.object_height >= 0 && model.object_height <= kLongestLength,
          "an object's height must lie in 0 .. 10 m");
  require(std::isnan(model.metres_per_pixel) ||
              (model.metres_per_pixel > 0 && model.metres_per_pixel <= kLongestLength),
          "an object's scale must lie above 0 and within 10 m per pixel, or be NaN for unknown");
  require(!model.min_score || (*model.min_score > 0 && *model.min_score <= 1),
          "an object's own threshold must lie in (0..1]");
  require(!model.symmetry || is_declarable_symmetry(*model.symmetry),
          "an object's declared symmetry must be 1 (none), 2 to 12, or 0 (round)");
  require(!model.grasp || is_sound(*model.grasp),
          "a grasp needs a position within 10 m and a unit quaternion");
  for (const auto& view : model.views) validate_view(view);
}

}  // namespace mbncc
