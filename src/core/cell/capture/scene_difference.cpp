// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/scene_difference.hpp"

#include <algorithm>

#include "mbncc/learning/change.hpp"

namespace mbncc {
namespace {

constexpr double kBorderShare = 0.01;  // part of the image's width that counts as its edge

bool reaches_border(const cv::Mat& changed) {
  const int border = std::max(2, cvRound(kBorderShare * changed.cols));
  const cv::Rect inside(border, border, changed.cols - 2 * border, changed.rows - 2 * border);
  return cv::countNonZero(changed) > cv::countNonZero(changed(inside));
}

}  // namespace

SceneDifference scene_difference(const cv::Mat& before, const cv::Mat& after) {
  const ChangeSurvey survey = survey_change(before, after);
  SceneDifference difference{SceneChange::kNone, survey.changed, survey.fraction, survey.exposure};
  if (survey.fraction > 0)
    difference.change =
        reaches_border(survey.changed) ? SceneChange::kAtBorder : SceneChange::kInside;
  return difference;
}

SceneChange scene_change(const cv::Mat& before, const cv::Mat& after) {
  return scene_difference(before, after).change;
}

}  // namespace mbncc
