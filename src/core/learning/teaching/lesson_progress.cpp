// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/lesson_progress.hpp"

#include <algorithm>

namespace mbncc::teaching {

void LessonProgress::report(Stage stage, double progress, const std::string& message,
                            const Image& image) {
  if (!observer_) return;
  highest_ = std::max(highest_, std::min(progress, 1.0));
  if (!observer_(stage, highest_, message, image ? image() : cv::Mat()))
    throw LessonEnded(LearnError::kCancelled);
}

}  // namespace mbncc::teaching
