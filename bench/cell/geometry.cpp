// SPDX-License-Identifier: BSD-3-Clause
// Accuracy in metres in the simulated cell with a strong lens: objects of several heights are
// taught at one place and found at others, in images from a rectified camera, in rectified raw
// images, and in raw images.
#include <filesystem>
#include <iostream>

#include "common/program.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/sim/scene.hpp"
#include "nodelets/camera/rectifier.hpp"
#include "nodelets/camera/simulated_optics.hpp"
#include "nodelets/conversion/rays.hpp"

namespace mbncc::bench {
namespace {

constexpr const char* kOptions =
    "{@out       |     | folder for geometry.csv }"
    "{poses      | 200 | poses of each way }"
    "{distortion | -0.3 | k1 of the lens }"
    "{help h     |     | this text }";

constexpr double kHeights[] = {0, 0.02, 0.04, 0.06};  // [m]
constexpr int kPosesPerObject = 10;
constexpr double kLearnedTheta = 0.4;  // [rad]
// Position [m] of the gripper in the object's frame: beside and above it.
const cv::Vec3d kGripper(0.02, 0.01, -0.1);

SimulatedCameraConfig camera_config(double distortion) {
  SimulatedCameraConfig config;
  config.width = 1280;
  config.height = 960;
  config.focal_length = 900;
  config.platform_distance = 0.8;
  config.principal_x = 45;
  config.principal_y = -30;
  config.distortion = distortion;
  return config;
}

/// How the images reach the search.
struct Way {
  std::string name;
  bool distorted;  ///< the camera sends raw images
  bool undone;     ///< the rectifier corrects them
};

const Way kWays[] = {{"rectified camera", false, false},
                     {"raw, rectify", true, true},
                     {"raw, rays only", true, false}};

struct Error {
  double position = 0;  ///< [m]
  double angle = 0;     ///< [rad]
  double grasp = 0;     ///< [m] error of the gripper's frame
  double claimed = 0;   ///< position error divided by its claimed deviation
};

class Cell {
 public:
  Cell(std::uint64_t seed, const SimulatedCameraConfig& config, const Way& way)
      : config_(config), way_(way), optics_(config), scene_(scene_config(seed)) {}

  cv::Mat image(const std::vector<sim::Placed>& placed, std::uint64_t frame) {
    const cv::Mat straight = scene_.render(placed, frame);
    if (!way_.distorted) return straight;
    const cv::Mat raw = optics_.distort(straight);
    return way_.undone ? rectifier_.rectify(raw, optics_.camera_info()).image : raw;
  }

  /// Metric pose of an object with this pixel pose in the images of this kind.
  std::optional<PlatformPose> lift(const Pose2D& pose, const cv::Matx33d& covariance,
                                   double height) const {
    const auto& info = optics_.camera_info();
    const bool rectified = !way_.distorted || way_.undone;
    const auto rays = nodelets::rays_of(info, rectified, {config_.width, config_.height});
    return Platform(*rays, plane_at(config_.platform_distance)).lift(pose, covariance, height);
  }

  /// Metric pose of a pixel pose in the undistorted image.
  PlatformPose truth(const Pose2D& pose, double height) const {
    const Platform platform(rays_of(optics_.pinhole()), plane_at(config_.platform_distance));
    return *platform.lift(pose, cv::Matx33d::zeros(), height);
  }

  cv::Size size() const { return {config_.width, config_.height}; }
  const Way& way() const { return way_; }

 private:
  sim::SceneConfig scene_config(std::uint64_t seed) const {
    sim::SceneConfig scene;
    scene.size = {config_.width, config_.height};
    scene.seed = seed;
    return scene;
  }

  SimulatedCameraConfig config_;
  Way way_;
  nodelets::SimulatedOptics optics_;
  nodelets::Rectifier rectifier_;
  sim::Scene scene_;
};

/// Position and rotation of a frame relative to another one.
PlatformPose relative(const PlatformPose& base, const PlatformPose& pose) {
  return {base.rotation.t() * (pose.position - base.position), base.rotation.t() * pose.rotation,
          cv::Matx66d::zeros()};
}

PlatformPose chained(const PlatformPose& base, const PlatformPose& pose) {
  return {base.position + base.rotation * pose.position, base.rotation * pose.rotation,
          cv::Matx66d::zeros()};
}

double angle_between(const cv::Matx33d& a, const cv::Matx33d& b) {
  const cv::Matx33d r = a.t() * b;
  return std::abs(std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1)));
}

Error compare(const PlatformPose& found, const PlatformPose& truth) {
  Error error;
  error.position = cv::norm(found.position - truth.position);
  error.angle = angle_between(found.rotation, truth.rotation);
  error.grasp = cv::norm(found.position + found.rotation * kGripper - truth.position -
                         truth.rotation * kGripper);
  error.claimed = error.position / std::sqrt(found.covariance(0, 0) + found.covariance(1, 1));
  return error;
}

struct Tally {
  std::vector<Error> errors;
  int poses = 0, untaught = 0;
};

/// Teaches one object in the centre of the image and searches it at other places.
void measure(Cell& cell, std::uint64_t seed, double height, Tally& tally) {
  cv::RNG random(seed);
  sim::Placed placed{{seed, random.uniform(80., 130.), random.uniform(1.2, 2.2)},
                     {620.3, 470.6, kLearnedTheta}};
  Lesson lesson;
  lesson.name = "part";
  lesson.before = cell.image({placed}, 1);
  lesson.after = cell.image({}, 2);
  const LearnResult learned = learn_object(lesson);
  if (learned.error != LearnError::kSuccess) {
    ++tally.untaught;
    return;
  }
  const Pose2D reference = learned.object.views.front().reference;
  const PlatformPose object = cell.truth(placed.pose, height);
  const PlatformPose frame = relative(object, *cell.lift(reference, {}, height));
  Matcher matcher;
  matcher.set_objects({std::make_shared<ObjectModel>(learned.object)});
  for (int i = 0; i < kPosesPerObject; ++i) {
    placed.pose = {random.uniform(170., 1110.), random.uniform(170., 790.),
                   random.uniform(-kPi, kPi)};
    ++tally.poses;
    const auto found = matcher.find(cell.image({placed}, 10 + i)).matches;
    if (found.empty() || !found.front().graspable) continue;
    const auto lifted = cell.lift(found.front().pose, found.front().covariance, height);
    if (lifted)
      tally.errors.push_back(compare(*lifted, chained(cell.truth(placed.pose, height), frame)));
  }
}

std::vector<std::string> row_of(const std::string& way, double height, const Tally& tally) {
  std::vector<double> position, angle, grasp, claimed;
  for (const auto& error : tally.errors) {
    position.push_back(1e3 * error.position);
    angle.push_back(to_degrees(error.angle));
    grasp.push_back(1e3 * error.grasp);
    claimed.push_back(error.claimed * error.claimed);
  }
  return {way,
          to_text(1e3 * height, 0),
          std::to_string(tally.poses),
          std::to_string(tally.errors.size()),
          to_text(median(position), 3),
          to_text(percentile(position, 95), 3),
          to_text(percentile(position, 100), 3),
          to_text(median(angle), 3),
          to_text(percentile(angle, 95), 3),
          to_text(median(grasp), 3),
          to_text(percentile(grasp, 95), 3),
          to_text(std::sqrt(mean(claimed)), 2)};
}

void benchmark(const cv::CommandLineParser& options) {
  const std::filesystem::path out = output_folder(options.get<std::string>("@out"));
  const int poses = options.get<int>("poses");
  const SimulatedCameraConfig config = camera_config(options.get<double>("distortion"));
  constexpr int kKinds = sizeof kHeights / sizeof *kHeights;
  const int objects = std::max(1, poses / kPosesPerObject / kKinds);
  Table table{{"images", "height mm", "poses", "graspable", "median mm", "95 % mm", "worst mm",
               "median deg", "95 % deg", "grasp median mm", "grasp 95 % mm", "error/sigma"},
              {}};
  for (const auto& way : kWays) {
    Tally all;
    for (const double height : kHeights) {
      Tally tally;
      for (int i = 0; i < objects; ++i) {
        Cell cell(static_cast<std::uint64_t>(i + 1), config, way);
        measure(cell, static_cast<std::uint64_t>(100 * i + cvRound(1000 * height) + 7), height,
                tally);
      }
      table.rows.push_back(row_of(way.name, height, tally));
      all.errors.insert(all.errors.end(), tally.errors.begin(), tally.errors.end());
      all.poses += tally.poses;
    }
    table.rows.push_back(row_of(way.name + ", all", 0, all));
    table.rows.back()[1] = "0 .. 60";
  }
  save_csv((out / "geometry.csv").string(), table);
  write_markdown(std::cout, table);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "geometry_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
