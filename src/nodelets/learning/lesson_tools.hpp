// SPDX-License-Identifier: BSD-3-Clause
// Dependencies and settings of a lesson.
#pragma once

#include <string>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "nodelets/learning/confirmation.hpp"
#include "nodelets/learning/image_feed.hpp"
#include "nodelets/learning/lesson_display.hpp"
#include "nodelets/learning/lesson_gauge.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// The references must outlive the lesson.
struct LessonTools {
  ImageFeed& images;
  SharedLibrary& library;
  Confirmation& confirmation;
  const LessonGauge& gauge;
  const LessonDisplay& display;
  LearningConfig config;
  SearchConfig search;    ///< settings with which the object will be searched
  std::string cell_name;  ///< stored with the object
};

}  // namespace mbncc::nodelets
