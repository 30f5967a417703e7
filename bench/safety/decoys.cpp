// SPDX-License-Identifier: BSD-3-Clause
#include "safety/decoys.hpp"

#include <array>
#include <opencv2/imgproc.hpp>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::bench {
namespace {

const cv::Size kSize(kDecoyWidth, kDecoyHeight);
constexpr std::uint64_t kStrangers = 1'000'000;  // first seed of the objects that are never taught

sim::Scene scene_by(cv::RNG& random) {
  sim::SceneConfig config;
  config.size = kSize;
  config.seed = static_cast<std::uint64_t>(random.uniform(1, 1 << 30));
  config.gain = random.uniform(0.8, 1.2);
  config.light_gradient = random.uniform(0.0, 0.3);
  config.noise_sigma = random.uniform(1.0, 4.0);
  return sim::Scene(config);
}

Pose2D pose_by(cv::RNG& random, double reach) {
  return {random.uniform(reach, kSize.width - reach), random.uniform(reach, kSize.height - reach),
          random.uniform(-kPi, kPi)};
}

sim::Placed stranger(cv::RNG& random) {
  sim::SceneObject drawing;
  drawing.seed = kStrangers + static_cast<std::uint64_t>(random.uniform(0, 1 << 30));
  drawing.diameter = random.uniform(35., 110.);
  drawing.elongation = random.uniform(1.0, 2.4);
  return {drawing, pose_by(random, 0.6 * drawing.diameter)};
}

/// Replaces the pixels under the object's map by those of a larger, unknown object at the same
/// pose.
void resurface(const sim::Scene& scene, const sim::Placed& placed, cv::Mat& image,
               cv::RNG& random) {
  sim::Placed cover = stranger(random);
  cover.pose = placed.pose;
  cover.object.diameter = 2.5 * placed.object.diameter;
  cover.object.elongation = 1;
  scene.render({cover}, random.next()).copyTo(image, scene.true_map(placed));
}

}  // namespace

std::vector<Taught> teach(int count, int seed) {
  cv::RNG random(static_cast<std::uint64_t>(seed));
  std::vector<Taught> taught;
  for (int i = 0; i < count; ++i) {
    sim::SceneObject drawing;
    drawing.seed = static_cast<std::uint64_t>(1000 * seed + i);
    drawing.diameter = random.uniform(35., 110.);
    drawing.elongation = random.uniform(1.0, 2.4);
    const sim::Scene scene = scene_by(random);
    const sim::Placed placed{drawing, {320.3, 240.6, random.uniform(-kPi, kPi)}};
    Lesson lesson;
    lesson.name = "part" + std::to_string(i);
    lesson.before = scene.render({placed}, 1);
    lesson.after = scene.render({}, 2);
    const LearnResult learned = learn_object(lesson);
    if (learned.error == LearnError::kSuccess)
      taught.push_back({drawing, std::make_shared<ObjectModel>(learned.object)});
  }
  return taught;
}

cv::Mat empty_image(cv::RNG& random) {
  cv::Mat image(kSize, CV_8UC3, cv::Scalar::all(0));
  const int kind = random.uniform(0, 3);
  if (kind == 1)
    image.setTo(cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256)));
  if (kind == 2) {
    image.setTo(cv::Scalar::all(random.uniform(60, 200)));
    cv::Mat noise(kSize, CV_8UC3);
    random.fill(noise, cv::RNG::NORMAL, 0, random.uniform(2., 60.));
    image += noise;
  }
  return image;
}

cv::Mat other_scene(cv::RNG& random) {
  const sim::Scene scene = scene_by(random);
  std::vector<sim::Placed> placed(static_cast<std::size_t>(random.uniform(3, 8)));
  for (auto& one : placed) one = stranger(random);
  return scene.render(placed, random.next());
}

cv::Mat part_of(const cv::Mat& photograph, cv::RNG& random) {
  const cv::Point2f centre(random.uniform(0.25F, 0.75F) * static_cast<float>(photograph.cols),
                           random.uniform(0.25F, 0.75F) * static_cast<float>(photograph.rows));
  cv::Mat motion =
      cv::getRotationMatrix2D(centre, random.uniform(0., 360.), random.uniform(0.8, 1.25));
  motion.at<double>(0, 2) += kSize.width / 2.0 - centre.x;
  motion.at<double>(1, 2) += kSize.height / 2.0 - centre.y;
  cv::Mat part;
  cv::warpAffine(photograph, part, motion, kSize, cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return part;
}

const char* to_string(Likeness likeness) {
  switch (likeness) {
    case Likeness::kMirrored:
      return "mirrored";
    case Likeness::kRecoloured:
      return "other colours";
    case Likeness::kResurfaced:
      return "other surface";
    default:
      return "other size";
  }
}

cv::Mat recoloured(const cv::Mat& image) {
  std::array<cv::Mat, 3> channels;
  cv::split(image, channels.data());
  std::rotate(channels.begin(), channels.begin() + 1, channels.end());
  cv::Mat exchanged;
  cv::merge(channels.data(), channels.size(), exchanged);
  return exchanged;
}

double colourfulness(const View& view) {
  cv::Mat difference;
  cv::absdiff(view.template_image, recoloured(view.template_image), difference);
  const cv::Scalar mean = cv::mean(difference, view.map);
  return (mean[0] + mean[1] + mean[2]) / 3;
}

cv::Mat scene_with_likeness(const Taught& object, Likeness likeness, cv::RNG& random) {
  const sim::Scene scene = scene_by(random);
  sim::Placed placed{object.drawing, pose_by(random, 0.8 * object.drawing.diameter)};
  if (likeness == Likeness::kResized) {
    const double factor = random.uniform(1.15, 1.35);
    placed.object.diameter *= random.uniform(0, 2) == 0 ? factor : 1 / factor;
  }
  cv::Mat image = scene.render({stranger(random), placed}, random.next());
  if (likeness == Likeness::kMirrored) cv::flip(image, image, 1);
  if (likeness == Likeness::kRecoloured) recoloured(image).copyTo(image, scene.true_map(placed));
  if (likeness == Likeness::kResurfaced) resurface(scene, placed, image, random);
  return image;
}

}  // namespace mbncc::bench
