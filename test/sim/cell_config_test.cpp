// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/sim/cell_config.hpp"

#include <gtest/gtest.h>

namespace mbncc::sim {
namespace {

TEST(CellConfig, SceneAndStoryShareImageSizeAndSeed) {
  SimulatedCameraConfig config;
  config.width = 320;
  config.height = 200;
  config.seed = 7;
  config.gain = 0.5;
  config.object_diameter = 44;
  config.neighbours = 5;
  const SceneConfig scene = scene_config(config);
  const CellScriptConfig script = script_config(config);
  EXPECT_EQ(scene.size, cv::Size(320, 200));
  EXPECT_EQ(scene.size, script.size);
  EXPECT_EQ(scene.seed, 7u);
  EXPECT_EQ(scene.seed, script.seed);
  EXPECT_EQ(scene.gain, 0.5);
  EXPECT_EQ(script.object.diameter, 44);
  EXPECT_EQ(script.neighbours, 5);
}

TEST(CellConfig, TimesAreConvertedToAtLeastOneImage) {
  SimulatedCameraConfig config;
  config.frame_rate = 20;
  config.rest_time = 3;
  config.leg_time = 0.01;
  EXPECT_EQ(script_config(config).rest_frames, 60);
  EXPECT_EQ(script_config(config).leg_frames, 1);
}

}  // namespace
}  // namespace mbncc::sim
