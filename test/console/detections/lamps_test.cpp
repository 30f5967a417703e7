// SPDX-License-Identifier: BSD-3-Clause
#include "console/detections/lamps.hpp"

#include <gtest/gtest.h>

#include "mbncc/health_tasks.hpp"

namespace mbncc::console {
namespace {

using mbncc_vision::DetectedObjectArray;

enum Which { kCamera, kCalibration, kLibrary, kMatcher };

DetectedObjectArray array(std::uint8_t status, const std::string& message = "") {
  DetectedObjectArray detections;
  detections.status = status;
  detections.message = message;
  return detections;
}

Lamps well(double now) {
  Lamps lamps;
  lamps.take_image(now);
  lamps.take_detections(array(DetectedObjectArray::OK), now);
  lamps.take_library(2, 1);
  return lamps;
}

/// A report of the matching nodelet about its library.
diagnostic_msgs::DiagnosticArray quarantine_of(const std::string& node, const std::string& files) {
  diagnostic_msgs::DiagnosticArray diagnostics;
  auto& status = diagnostics.status.emplace_back();
  status.name = node + ": " + kMatchingTask;
  auto& value = status.values.emplace_back();
  value.key = kQuarantinedKey;
  value.value = files;
  return diagnostics;
}

TEST(Lamps, AllAreGoodInNormalOperation) {
  for (const auto& lamp : well(10).look(11)) {
    EXPECT_EQ(lamp.level, Level::kGood) << lamp.name;
    EXPECT_EQ(lamp.reason, "");
  }
}

TEST(Lamps, EachFaultHasAReason) {
  const auto lamps = Lamps().look(10);
  for (const auto& lamp : lamps) {
    EXPECT_NE(lamp.level, Level::kGood) << lamp.name;
    EXPECT_NE(lamp.reason, "") << lamp.name;
  }
}

TEST(Lamps, SilenceIsDetectedWithinThreeSeconds) {
  const auto lamps = well(10).look(12.5);
  EXPECT_EQ(lamps[kCamera].level, Level::kBad);
  EXPECT_EQ(lamps[kMatcher].level, Level::kBad);
}

/// A report of the camera nodelet, named as diagnostic_updater names it.
diagnostic_msgs::DiagnosticArray complaint_of(const std::string& node, const std::string& message) {
  diagnostic_msgs::DiagnosticArray diagnostics;
  auto& status = diagnostics.status.emplace_back();
  status.name = node + ": " + kImagesTask;
  status.level = diagnostic_msgs::DiagnosticStatus::ERROR;
  status.message = message;
  return diagnostics;
}

TEST(Lamps, ImagesThatAreNotLiveAreReported) {
  Lamps lamps;
  lamps.take_image(10);
  lamps.take_origin("THE SAME IMAGE");
  EXPECT_EQ(lamps.look(11)[kCamera].level, Level::kDoubtful);
  EXPECT_EQ(lamps.look(11)[kCamera].reason, "THE SAME IMAGE");
  lamps.take_origin("");
  EXPECT_EQ(lamps.look(11)[kCamera].level, Level::kGood);
}

TEST(Lamps, TheCamerasOwnFaultIsShown) {
  Lamps lamps = well(10);
  lamps.take_diagnostics(complaint_of("camera", "/dev/video0 is gone"), 13);
  EXPECT_EQ(lamps.look(13)[kCamera].reason, "/dev/video0 is gone");
}

TEST(Lamps, OnlyFaultsOfTheOwnCellAreShown) {
  Lamps left("/left"), right("/right"), alone;
  for (Lamps* lamps : {&left, &right, &alone}) {
    lamps->take_diagnostics(complaint_of("left/camera", "/dev/video0 is gone"), 13);
    lamps->take_diagnostics(quarantine_of("right/matching", "3"), 13);
    lamps->take_library(2, 2);
  }
  EXPECT_EQ(left.look(13)[kCamera].reason, "/dev/video0 is gone");
  EXPECT_EQ(left.look(13)[kLibrary].level, Level::kGood);
  EXPECT_NE(right.look(13)[kCamera].reason, "/dev/video0 is gone");
  EXPECT_EQ(right.look(13)[kLibrary].level, Level::kDoubtful);
  EXPECT_NE(alone.look(13)[kCamera].reason, "/dev/video0 is gone");
  EXPECT_EQ(alone.look(13)[kLibrary].level, Level::kGood);
}

TEST(Lamps, TheStatusOfTheSearchIsShown) {
  Lamps lamps = well(10);
  lamps.take_detections(array(DetectedObjectArray::UNCALIBRATED, "no camera_info"), 10);
  EXPECT_EQ(lamps.look(10)[kCalibration].level, Level::kDoubtful);
  EXPECT_EQ(lamps.look(10)[kCalibration].reason, "no camera_info");
  lamps.take_detections(array(DetectedObjectArray::STALE), 10);
  EXPECT_EQ(lamps.look(10)[kMatcher].level, Level::kBad);
  EXPECT_EQ(lamps.look(10)[kCalibration].level, Level::kUnknown);
  lamps.take_detections(array(DetectedObjectArray::SEARCH_FAILED, "out of memory"), 10);
  EXPECT_EQ(lamps.look(10)[kMatcher].level, Level::kBad);
  EXPECT_EQ(lamps.look(10)[kMatcher].reason, "out of memory");
  EXPECT_EQ(lamps.look(10)[kCalibration].level, Level::kUnknown);
}

TEST(Lamps, AnEmptyDisabledOrDamagedLibraryIsShown) {
  Lamps lamps = well(10);
  lamps.take_library(0, 0);
  EXPECT_EQ(lamps.look(10)[kLibrary].level, Level::kDoubtful);
  lamps.take_library(2, 0);
  EXPECT_EQ(lamps.look(10)[kLibrary].level, Level::kDoubtful);
  lamps.take_library(2, 2);
  lamps.take_diagnostics(quarantine_of("matching", "1"), 10);
  EXPECT_EQ(lamps.look(10)[kLibrary].level, Level::kDoubtful);
}

TEST(Lamps, ALibraryWithoutItsNodeletIsUnknown) {
  Lamps lamps = well(10);
  ASSERT_EQ(lamps.look(10)[kLibrary].level, Level::kGood);
  lamps.forget_library();
  EXPECT_EQ(lamps.look(10)[kLibrary].level, Level::kUnknown);
}

}  // namespace
}  // namespace mbncc::console
