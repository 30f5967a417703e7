// SPDX-License-Identifier: BSD-3-Clause
// A chessboard, drawn as a known camera sees it.
#pragma once

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "console/calibration/board_calibration.hpp"

namespace mbncc::console {

inline const Board kBoard{7, 5, 0.03};
inline const cv::Size kImage(640, 480);
inline const cv::Matx33d kMatrix(600, 0, 315, 0, 600, 245, 0, 0, 1);

/// `turn` and `place` [m] of the board's first inner corner in the camera's frame.
inline cv::Mat board_at(const cv::Vec3d& turn, const cv::Vec3d& place,
                        const Board& board = kBoard) {
  cv::Mat image(kImage, CV_8UC3, cv::Scalar::all(200));
  for (int row = -1; row < board.rows; ++row)
    for (int column = -1; column < board.columns; ++column) {
      if ((row + column) % 2 == 0) continue;
      std::vector<cv::Point3d> square;
      for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        square.emplace_back((column + x) * board.square, (row + y) * board.square, 0);
      std::vector<cv::Point2d> seen;
      cv::projectPoints(square, turn, place, kMatrix, cv::noArray(), seen);
      std::vector<cv::Point> fixed;
      for (const auto& point : seen)
        fixed.emplace_back(cvRound(point.x * 256), cvRound(point.y * 256));
      cv::fillConvexPoly(image, fixed, cv::Scalar::all(20), cv::LINE_AA, 8);
    }
  return image;
}

}  // namespace mbncc::console
