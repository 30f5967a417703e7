// SPDX-License-Identifier: BSD-3-Clause
// A learned object: made by a lesson, stored by the library and searched by matching.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc {

enum class Verdict : std::uint8_t { kGood = 0, kMarginal = 1, kBad = 2 };

/// "GOOD", "MARGINAL" or "BAD".
const char* to_string(Verdict verdict);

/// Verdict on a learned map and template; the fields are those of msg/LearnQuality.msg.
struct Quality {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  Verdict verdict = Verdict::kGood;
  std::vector<std::string> reasons;  ///< machine keys, worst first; printable
  std::vector<std::string> advice;   ///< one plain sentence per reason; printable
  double area = 0;                   ///< [px] number of map pixels
  double fill = 0;                   ///< [0..1] map pixels / pixels of the excircle
  double contrast = 0;        ///< [grey levels] standard deviation of the template under the map
  double edge_agreement = 0;  ///< [0..1] fraction of the outline that lies on an image edge
  double change_agreement =
      kUnknown;  ///< [0..1] IoU with the before/after difference; NaN: no after
  double outline_probability = kUnknown;  ///< [0..1] probability that the map's IoU with the object
                                          ///< is at least .8; NaN: the map was given
  double self_score = 0;                  ///< [0..1] score of the object in its learning image
  double self_error = 0;        ///< [px] distance of that detection from the reference point
  double runner_up = 0;         ///< [0..1] best score elsewhere in that image
  double angle_halfwidth = 0;   ///< [rad] rotation at which the score falls half-way to runner_up
  int symmetry = 1;             ///< 1: none, 2: 180 deg, 3: 120 deg, ... 0: round
  std::string confusable_with;  ///< name of the stored object that scores highest here, or ""
  double confusable_score = 0;  ///< [0..1]
  double search_time = 0;       ///< [s] one full search for this object
};

/// Larger lengths of objects and grasps are refused. [m]
constexpr double kLongestLength = 10;

/// References farther from their image's corner, in x or y, are refused. [px]
constexpr double kFarthestReference = 1 << 17;

/// One learning image of the object, cropped to the excircle of its map plus a margin.
struct View {
  cv::Mat template_image;  ///< CV_8UC3 bgr, the learning image around the object
  cv::Mat map;             ///< CV_8UC1, 255 on the object, 0 elsewhere; same size
  cv::Point origin;        ///< [px] top left corner of the crop in the learning image
  cv::Size image_size;     ///< [px] of the learning image, within ImageLimits
  Pose2D reference;        ///< [px],[rad] object frame in the learning image
};

/// Gripper pose relative to the object frame.
struct Grasp {
  std::array<double, 3> position{};                 ///< [m] within kLongestLength
  std::array<double, 4> orientation{{0, 0, 0, 1}};  ///< unit quaternion x, y, z, w
};

struct ObjectModel {
  std::string name;            ///< library key, see is_valid_name()
  std::string label;           ///< shown to the operator, see is_valid_label()
  bool enabled = true;         ///< searched for
  std::uint32_t revision = 1;  ///< +1 for every new lesson, added view or edit that moves poses
  double learned_at = 0;       ///< [s] since 1970-01-01 UTC
  std::string taught_by;       ///< cell of that lesson, a label; "": unknown
  double metres_per_pixel = Quality::kUnknown;  ///< on the top face; NaN: learned without scale
  double object_height = 0;  ///< [m] top face above the platform, 0 .. kLongestLength
  std::optional<Grasp> grasp;
  std::optional<double> min_score;  ///< (0..1] own threshold; none: the matcher's
  std::optional<int> symmetry;      ///< declared, see is_declarable_symmetry(); none: measured
  Quality quality;
  std::vector<View> views;  ///< at least one; views.front() is the one learned first
};

/// Names serve as file names and tf frames: [A-Za-z][A-Za-z0-9_]{0,63}.
bool is_valid_name(const std::string& name);

/// Cuts a view out of a learning image: the bounding box of the map's excircle plus `margin`
/// pixels, clipped to the image. `image` is CV_8UC3, `map` a non-empty binary map of the same
/// size. Throws std::invalid_argument if their sizes differ.
View crop_view(const cv::Mat& image, const cv::Mat& map, const Pose2D& reference, int margin = 12);

/// The view's map at the size of the learning image, in its coordinates.
cv::Mat full_size_map(const View& view);

/// The `part` [px] of full_size_map().
cv::Mat map_within(const View& view, const cv::Rect& part);

/// Outlines of the map (outer contours, largest first) relative to the reference point, in the
/// object frame's directions. [px]
std::vector<std::vector<cv::Point2f>> outlines(const View& view);

/// Moves the object frame: `reference` is its new pose in the first learning image. The frames of
/// further views move along, and a grasp is converted to the new frame, assuming that the camera
/// points straight down. Throws std::invalid_argument if `reference` is not finite, or if a grasp
/// is set but the scale is unknown, because the grasp would then be wrong.
void move_reference(ObjectModel& model, const Pose2D& reference);

/// Throws std::invalid_argument that names the fault if the model violates a rule stated above.
void validate(const ObjectModel& model);

}  // namespace mbncc
