// SPDX-License-Identifier: BSD-3-Clause
// Names of the nodelets' reports on /diagnostics, shared by the nodelets and the console.
#pragma once

namespace mbncc {

constexpr char kImagesTask[] = "pictures";  ///< of the camera
constexpr char kLearningTask[] = "learning";
constexpr char kMatchingTask[] = "matching";
constexpr char kVisionTask[] = "vision_msgs";

/// Key of a number in the reports of learning and matching.
constexpr char kQuarantinedKey[] = "files quarantined";

}  // namespace mbncc
