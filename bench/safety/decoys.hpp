// SPDX-License-Identifier: BSD-3-Clause
// Images that lack an object: other scenes, nothing at all, and its likes.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {

/// An object taught in the simulated cell by taking it away.
struct Taught {
  sim::SceneObject drawing;
  std::shared_ptr<const ObjectModel> model;
};

/// `count` objects of 35 to 110 px, drawn by `seed`. Those whose lesson is refused are left out.
std::vector<Taught> teach(int count, int seed);

/// Images are CV_8UC3 of this size.
constexpr int kDecoyWidth = 640, kDecoyHeight = 480;

/// Black, of one colour, or pure noise.
cv::Mat empty_image(cv::RNG& random);

/// Another platform in other light with three to seven objects drawn nowhere else.
cv::Mat other_scene(cv::RNG& random);

/// A part of a photograph, turned and resized by up to a quarter.
cv::Mat part_of(const cv::Mat& photograph, cv::RNG& random);

/// How a thing that is not the object resembles it.
enum class Likeness { kMirrored, kRecoloured, kResurfaced, kResized };
const char* to_string(Likeness likeness);

/// A scene with a thing like the object in it: the object seen in a mirror; its outline and
/// surface with exchanged colours; its outline with another one's surface; or the object 15 to 35 %
/// larger or smaller.
cv::Mat scene_with_likeness(const Taught& object, Likeness likeness, cv::RNG& random);

/// The image with red, green and blue exchanged: whatever was taught by colour is something else
/// in it.
cv::Mat recoloured(const cv::Mat& image);

/// Mean difference of the channels under the map: below some 30 recolouring changes too little.
double colourfulness(const View& view);

}  // namespace mbncc::bench
