// SPDX-License-Identifier: BSD-3-Clause
// What a lesson works with, and where it shows what it has learned.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>

#include <functional>
#include <opencv2/core.hpp>
#include <string>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"
#include "nodelets/learning/confirmation.hpp"
#include "nodelets/learning/image_feed.hpp"
#include "nodelets/learning/lesson_gauge.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

struct LessonDisplay {
  std::function<void(const cv::Mat&)> stage;  ///< of the segmentation
  std::function<void(const cv::Mat&)> preview;
  std::function<void(const cv::Mat&)> image;  ///< without annotations, before its draft
  std::function<void(const mbncc_vision::LearnObjectResult&)> draft;
  std::function<void(const ObjectModel&, const cv::Mat& image)> score_map;
};

/// All outlive the lesson.
struct LessonTools {
  ImageFeed& images;
  SharedLibrary& library;
  Confirmation& confirmation;
  const LessonGauge& gauge;
  LearningConfig config;
  SearchConfig search;    ///< that will look for the object
  std::string cell_name;  ///< stored with the object
  LessonDisplay display;
};

}  // namespace mbncc::nodelets
