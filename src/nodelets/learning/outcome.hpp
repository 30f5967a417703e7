// SPDX-License-Identifier: BSD-3-Clause
// The result of a lesson for its client.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>

#include <opencv2/core.hpp>
#include <string>

#include "mbncc/learning/lesson.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "nodelets/learning/image_feed.hpp"

namespace mbncc::nodelets {

/// Result with code, message and hint of `error`; texts that are not empty replace the defaults.
mbncc_vision::LearnObjectResult outcome(LearnError error, const std::string& message = "",
                                        const std::string& hint = "");

mbncc_vision::LearnObjectResult outcome(const Refusal& refusal);

/// Result of learning from `image`, with the object if there is one.
mbncc_vision::LearnObjectResult outcome(const LearnResult& learned, const LessonImage& image);

/// `result` with the object, its newest view's map and template, and the preview.
mbncc_vision::LearnObjectResult with_object(mbncc_vision::LearnObjectResult result,
                                            const ObjectModel& model, const LessonImage& image);

/// The newest view drawn into its learning image. CV_8UC3
cv::Mat preview_of(const ObjectModel& model, const cv::Mat& image);

}  // namespace mbncc::nodelets
