// SPDX-License-Identifier: BSD-3-Clause
// An operator who hesitates, reaches in, pauses, or first puts objects down or aside.
#pragma once

#include <opencv2/core.hpp>

#include "cell/lesson_cell.hpp"
#include "mbncc/cell/demonstration.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::bench {

/// How the operator demonstrates the object.
enum class Way { kTakenAway, kPutAside, kAlreadyMoved, kPutDownFirst };

struct Outcome {
  LearnResult learned;
  Pose2D shown;  ///< pose of the object in the image before
  bool timed_out = false;
};

/// One lesson with its operator.
class Demo {
 public:
  Demo(LessonCell& cell, Way way, cv::RNG& random) : cell_(cell), way_(way), random_(random) {}

  Outcome run();

 private:
  void act();
  Outcome already_moved();
  Outcome learn(const cv::Mat& before, const cv::Mat& after) const;

  LessonCell& cell_;
  const Way way_;
  cv::RNG& random_;
  int hesitation_ = random_.uniform(0, 10);
  int intrusions_ = random_.uniform(0, 3);
  Pose2D shown_;
};

}  // namespace mbncc::bench
