// SPDX-License-Identifier: BSD-3-Clause
// Images that do not contain an object: other scenes, empty images, and similar objects.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {

/// An object that was taught in the simulated cell by taking it away.
struct Taught {
  sim::SceneObject drawing;
  std::shared_ptr<const ObjectModel> model;
};

/// `count` random objects of 35 to 110 px; `seed` determines them. Objects whose lesson is refused
/// are left out.
std::vector<Taught> teach(int count, int seed);

/// All images are CV_8UC3 of this size.
constexpr int kDecoyWidth = 640, kDecoyHeight = 480;

/// A black image, an image of one colour, or pure noise.
cv::Mat empty_image(cv::RNG& random);

/// Another platform in different light with three to seven objects that occur nowhere else.
cv::Mat other_scene(cv::RNG& random);

/// A part of a photograph, rotated and resized by up to a quarter.
cv::Mat part_of(const cv::Mat& photograph, cv::RNG& random);

/// How a decoy resembles the object.
enum class Likeness { kMirrored, kRecoloured, kResurfaced, kResized };
const char* to_string(Likeness likeness);

/// A scene with a decoy: the mirror image of the object; its outline and surface with exchanged
/// colours; its outline with the surface of another object; or the object 15 to 35 % larger or
/// smaller.
cv::Mat scene_with_likeness(const Taught& object, Likeness likeness, cv::RNG& random);

/// The image with exchanged red, green and blue channels, so that a coloured object counts as a
/// different one.
cv::Mat recoloured(const cv::Mat& image);

/// Mean difference of the channels under the map; below about 30, exchanging channels changes too
/// little.
double colourfulness(const View& view);

}  // namespace mbncc::bench
