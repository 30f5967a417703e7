// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <fstream>
#include <iostream>

#include "cli/command.hpp"
#include "cli/images.hpp"
#include "cli/report/numbers.hpp"
#include "cli/settings.hpp"
#include "cli/terminal/progress.hpp"
#include "mbncc/error.hpp"
#include "mbncc/sim/cell_config.hpp"

namespace mbncc::cli {
namespace {

/// Plays the script until the arm has left the image.
void play_to_rest(sim::CellScript& script) {
  while (!script.at_rest()) script.step();
}

std::string image_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "target_%03d.png", index);
  return name;
}

/// Runs a simulated cell and writes the images of its camera.
class RecordedCell {
 public:
  RecordedCell(std::string folder, const SimulatedCameraConfig& config)
      : folder_(std::move(folder)),
        scene_(sim::scene_config(config)),
        script_(sim::script_config(config)) {}

  sim::CellScript& script() { return script_; }

  void write(const std::string& name) {
    play_to_rest(script_);
    write_image(folder_ + "/" + name, scene_.render(script_.frame().placed, images_++), {});
  }

 private:
  std::string folder_;
  sim::Scene scene_;
  sim::CellScript script_;
  std::uint64_t images_ = 0;
};

void write_lesson(RecordedCell& cell) {
  cell.write("before.png");
  cell.script().take_away();
  cell.write("after.png");
}

void write_targets(RecordedCell& cell, int count, std::ostream& truth) {
  truth << "image,x,y,theta_deg\n";
  Progress progress("drawn", static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    cell.script().put_next();
    cell.write(image_name(i));
    const Pose2D pose = *cell.script().frame().truth;
    truth << image_name(i) << ',' << pose.x << ',' << pose.y << ',' << to_degrees(pose.theta)
          << '\n';
    progress.step();
  }
}

/// The script moves only on request and depends only on the seed.
SimulatedCameraConfig cell_of(const Arguments& arguments) {
  SimulatedCameraConfig config = simulated_camera_from(arguments);
  config.auto_play = false;
  if (arguments.has("--seed"))
    config.seed = config.object_seed = parse_whole("--seed", arguments.get("--seed"), 1);
  return config;
}

ExitCode run(const Arguments& arguments) {
  const std::string folder = arguments.get("--out");
  const int count = parse_whole("--count", arguments.get("--count", "5"), 1);
  const SimulatedCameraConfig config = cell_of(arguments);
  make_output_folder(folder);
  RecordedCell cell(folder, config);
  write_lesson(cell);
  const std::string truth_path = folder + "/truth.csv";
  std::ofstream truth(truth_path);
  write_targets(cell, count, truth);
  if (!truth.flush())
    throw FileError(truth_path, "cannot be written; check disk space and permissions");
  std::cerr << "mbncc: wrote before.png, after.png, " << count << " targets and truth.csv to "
            << folder << '\n';
  return kDone;
}

}  // namespace

Command simulate_command() {
  return {"simulate",
          "write images of the simulated cell, to try the tool without a camera",
          {{"--out", "DIR", "folder for the images", true},
           {"--seed", "N", "seed of platform, object and poses (1)"},
           {"--count", "N", "images to search (5)"}},
          "",
          "before.png and after.png teach the object, target_*.png show it elsewhere, truth.csv "
          "gives\n its pose: the centroid of its outline and its angle relative to before.png. Of "
          "the simulated\n camera's parameters, those of image, object, neighbours, noise and "
          "light are used.\n",
          run};
}

}  // namespace mbncc::cli
