// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/board_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace mbncc::console {
namespace {

constexpr double kOtherView = 0.06;  // of the width: least motion of the corners between views
constexpr std::size_t kViews = 8;
constexpr int kCovered = 12;           // [fields] minimum number covered
constexpr int kPose = 6, kCamera = 8;  // numbers of parameters: fx, fy, cx, cy, k1, k2, p1, p2

double distance(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += cv::norm(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

std::vector<cv::Point3f> corners_of(const Board& board) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      corners.emplace_back(static_cast<float>(column * board.square),
                           static_cast<float>(row * board.square), 0.f);
  return corners;
}

sensor_msgs::CameraInfo info_of(const cv::Mat& matrix, const cv::Mat& distortion, cv::Size size) {
  sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(size.width);
  info.height = static_cast<std::uint32_t>(size.height);
  info.distortion_model = "plumb_bob";
  for (int i = 0; i < 9; ++i) info.K[i] = matrix.at<double>(i / 3, i % 3);
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const cv::Mat straight = cv::getOptimalNewCameraMatrix(matrix, distortion, size, 0);
  for (int i = 0; i < 12; ++i) info.P[i] = i % 4 < 3 ? straight.at<double>(i / 4, i % 4) : 0;
  for (int i = 0; i < 5; ++i) info.D.push_back(distortion.at<double>(i));
  return info;
}

/// What one view, whose pose is unknown, says about the camera: its part of the normal matrix, with
/// focal lengths relative to `matrix`.
cv::Mat normal_matrix(const cv::Mat& jacobian, const cv::Mat& matrix) {
  const cv::Mat pose = jacobian.colRange(0, kPose);
  cv::Mat camera = jacobian.colRange(kPose, kPose + kCamera).clone(), absorbed;
  camera.col(0) *= matrix.at<double>(0, 0);
  camera.col(1) *= matrix.at<double>(1, 1);
  cv::solve(pose, camera, absorbed, cv::DECOMP_QR);
  camera -= pose * absorbed;
  return camera.t() * camera;
}

/// Standard deviation of the focal length, divided by it. That of cv::calibrateCamera() leaves out
/// what the views do not determine, and is then close to 0.
double focal_deviation(const cv::Mat& normal, double variance_px) {
  cv::Mat covariance;
  if (cv::invert(normal, covariance, cv::DECOMP_CHOLESKY) == 0)
    return std::numeric_limits<double>::infinity();
  return std::sqrt(variance_px *
                   std::max(covariance.at<double>(0, 0), covariance.at<double>(1, 1)));
}

}  // namespace

BoardCalibration::Seen BoardCalibration::take(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_RGB2GRAY);
  corners_.clear();
  std::vector<cv::Point2f> found;
  if (!cv::findChessboardCorners(
          grey, {board_.columns, board_.rows}, found,
          cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK))
    return Seen::kNothing;
  cv::cornerSubPix(grey, found, {5, 5}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 30, 0.01});
  const float scale = static_cast<float>(size_.width) / static_cast<float>(grey.cols);
  for (auto& corner : found)
    corner = (corner + cv::Point2f(0.5f, 0.5f)) * scale - cv::Point2f(0.5f, 0.5f);
  corners_ = found;
  const bool known = std::any_of(views_.begin(), views_.end(), [&](const auto& view) {
    return distance(view, found) < kOtherView * size_.width;
  });
  if (known) return Seen::kKnown;
  views_.push_back(found);
  for (const auto& corner : found)
    fields_.insert(static_cast<int>(corner.y * kFields / static_cast<float>(size_.height)) *
                       kFields +
                   static_cast<int>(corner.x * kFields / static_cast<float>(size_.width)));
  return Seen::kTaken;
}

std::vector<cv::Point2f> BoardCalibration::outline_of(
    const std::vector<cv::Point2f>& corners) const {
  const auto columns = static_cast<std::size_t>(board_.columns);
  return {corners.front(), corners[columns - 1], corners.back(), corners[corners.size() - columns]};
}

std::vector<std::vector<cv::Point2f>> BoardCalibration::outlines() const {
  std::vector<std::vector<cv::Point2f>> outlines;
  for (const auto& view : views_) outlines.push_back(outline_of(view));
  return outlines;
}

std::vector<cv::Point2f> BoardCalibration::outline() const {
  return corners_.empty() ? corners_ : outline_of(corners_);
}

bool BoardCalibration::suffices() const {
  return views_.size() >= kViews && covered() >= kCovered;
}

std::string BoardCalibration::advice(Seen seen) const {
  const std::string state = std::to_string(views_.size()) + " images taken, " +
                            std::to_string(covered()) + " of " + std::to_string(kFields * kFields) +
                            " fields covered. ";
  if (seen == Seen::kNothing)
    return state + "No complete board of " + std::to_string(board_.columns) + " x " +
           std::to_string(board_.rows) +
           " inner corners is visible. Move the whole board into view.";
  if (suffices()) return state + "Compute the calibration, or continue for a better one.";
  if (covered() < kCovered)
    return state +
           "Move the board to fields not covered yet, including the corners, and tilt it each "
           "time.";
  return state + "Tilt the board and vary its distance.";
}

BoardCalibration::Result BoardCalibration::solve() const {
  const std::vector<std::vector<cv::Point3f>> board(views_.size(), corners_of(board_));
  cv::Mat matrix, distortion;
  std::vector<cv::Mat> turns, places;
  Result result;
  result.error_px = cv::calibrateCamera(board, views_, size_, matrix, distortion, turns, places,
                                        cv::CALIB_FIX_K3);
  cv::Mat normal = cv::Mat::zeros(kCamera, kCamera, CV_64F), jacobian;
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t view = 0; view < views_.size(); ++view) {
    std::vector<cv::Point2f> back;
    cv::projectPoints(board[view], turns[view], places[view], matrix, distortion, back, jacobian);
    normal += normal_matrix(jacobian, matrix);
    const double mm = 1000 * places[view].at<double>(2) / matrix.at<double>(0, 0);
    for (std::size_t i = 0; i < back.size(); ++i, ++count)
      squares += std::pow(mm * cv::norm(back[i] - views_[view][i]), 2);
  }
  const auto corners = static_cast<double>(count), views = static_cast<double>(views_.size());
  result.error_mm = std::sqrt(squares / corners);
  result.focal_deviation = focal_deviation(
      normal, std::pow(result.error_px, 2) * corners / (2 * corners - kCamera - kPose * views));
  result.info = info_of(matrix, distortion, size_);
  return result;
}

}  // namespace mbncc::console
