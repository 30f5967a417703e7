// SPDX-License-Identifier: BSD-3-Clause
// Stores what a lesson has learned, with its metric data.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnObjectResult.h>
#include <ros/time.h>

#include <string>

#include "mbncc/learning/lesson.hpp"
#include "nodelets/learning/lesson_images.hpp"
#include "nodelets/learning/lesson_tools.hpp"
#include "nodelets/library/lesson_attempts.hpp"

namespace mbncc::nodelets {

class LessonStore {
 public:
  /// For a lesson that begins now. The references must outlive this object. `name` is the name of
  /// the object.
  LessonStore(const mbncc_vision::LearnObjectGoal& goal, std::string name, const LessonTools& tools,
              const LessonImages& images);

  /// Stores the object and returns the result for the client, also after a failure; can be
  /// repeated then. Scale and grasp are computed from `calibration`.
  mbncc_vision::LearnObjectResult store(const LearnResult& learned, const Calibration& calibration);

 private:
  std::string measure(ObjectModel& model, const Calibration& calibration) const;
  std::string missing_data_message(const LessonMeasures& measures) const;
  ObjectModel save(ObjectModel model, const Calibration& calibration, std::string& lacking);

  const mbncc_vision::LearnObjectGoal& goal_;
  const std::string name_;
  const LessonTools& tools_;
  const LessonImages& images_;
  const ros::Time started_;
  LessonAttempts attempts_;
};

}  // namespace mbncc::nodelets
