// SPDX-License-Identifier: BSD-3-Clause
// Writes an evaluation set (bench/README.md) drawn in the simulated cell, for users without other
// data.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "common/program.hpp"
#include "common/table.hpp"
#include "mbncc/geometry.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@out    |   | folder for the cases }"
    "{cases   | 8 | number of objects }"
    "{targets | 4 | images to search with each; the last one lacks the object }"
    "{seed    | 1 | random seed }"
    "{help h  |   | this text }";

constexpr int kNeighbours = 2;
constexpr double kMargin = 0.15;  // of the true map's box, since the operator's region is rough

struct Cell {
  sim::Scene scene;
  sim::SceneObject object;
  cv::RNG random;

  /// A pose whose circle lies in the `column`-th third of the image.
  Pose2D place(int column, double diameter) {
    const double width = scene.config().size.width / 3.0, reach = 0.6 * diameter;
    const double low = column * width + reach, high = (column + 1) * width - reach;
    return {random.uniform(std::min(low, high), std::max(low, high)),
            random.uniform(reach, scene.config().size.height - reach), random.uniform(-kPi, kPi)};
  }
};

Cell cell_of(std::uint64_t seed) {
  Cell cell;
  cell.random = cv::RNG(seed);
  sim::SceneConfig config;
  config.seed = seed;
  config.light_gradient = cell.random.uniform(0.05, 0.3);
  cell.scene = sim::Scene(config);
  cell.object = {seed, cell.random.uniform(60.0, 160.0), cell.random.uniform(1.0, 3.5)};
  return cell;
}

std::vector<sim::Placed> neighbours_of(Cell& cell) {
  std::vector<sim::Placed> neighbours;
  for (int i = 0; i < kNeighbours; ++i) {
    const sim::SceneObject object{cell.object.seed + 1000 + i, 80, 1.5};
    neighbours.push_back({object, cell.place(2 * i, object.diameter)});
  }
  return neighbours;
}

void save(const fs::path& path, const cv::Mat& image) {
  if (!cv::imwrite(path.string(), image))
    throw std::runtime_error("cannot write '" + path.string() + "'");
}

void save(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  if (!(file << text)) throw std::runtime_error("cannot write '" + path.string() + "'");
}

cv::Rect rough(const cv::Mat& map) {
  const cv::Rect box = cv::boundingRect(map);
  const cv::Size more(cvRound(kMargin * box.width), cvRound(kMargin * box.height));
  return (box - cv::Point(more) + more * 2) & cv::Rect({}, map.size());
}

void write_lesson(const fs::path& folder, Cell& cell) {
  auto placed = neighbours_of(cell);
  save(folder / "learn_after.png", cell.scene.render(placed, 2));
  placed.push_back({cell.object, cell.place(1, cell.object.diameter)});
  placed.back().pose.theta = 0;
  save(folder / "learn_before.png", cell.scene.render(placed, 1));
  const cv::Mat map = cell.scene.true_map(placed.back());
  save(folder / "gt_mask.png", map);
  const cv::Rect box = rough(map);
  const Pose2D& pose = placed.back().pose;
  save(folder / "roi.txt", std::to_string(box.x) + " " + std::to_string(box.y) + " " +
                               std::to_string(box.width) + " " + std::to_string(box.height) + "\n");
  save(folder / "ref.txt", to_text(pose.x, 4) + " " + to_text(pose.y, 4) + "\n");
  save(folder / "meta.json", "{\"tags\": []}\n");
}

void write_targets(const fs::path& folder, int count, Cell& cell) {
  Table truth{{"target", "instance", "x", "y", "theta_deg", "occlusion", "tags"}, {}};
  Table targets{{"target", "tags"}, {}};
  for (int i = 0; i < count; ++i) {
    const std::string name = "target_" + std::to_string(i);
    auto placed = neighbours_of(cell);
    if (i + 1 < count) {
      placed.push_back({cell.object, cell.place(1, cell.object.diameter)});
      const Pose2D& pose = placed.back().pose;
      truth.rows.push_back({name, "0", to_text(pose.x, 4), to_text(pose.y, 4),
                            to_text(to_degrees(pose.theta), 4), "0", ""});
    }
    targets.rows.push_back({name, ""});
    save(folder / (name + ".png"), cell.scene.render(placed, 10 + i));
  }
  save_csv((folder / "gt.csv").string(), truth);
  save_csv((folder / "targets.csv").string(), targets);
}

void write_set(const cv::CommandLineParser& options) {
  const fs::path out = output_folder(options.get<std::string>("@out"));
  for (int i = 0; i < options.get<int>("cases"); ++i) {
    const fs::path folder = out / ("case_" + std::string(i < 10 ? "0" : "") + std::to_string(i));
    fs::create_directories(folder);
    Cell cell = cell_of(static_cast<std::uint64_t>(1000 * options.get<int>("seed") + i));
    write_lesson(folder, cell);
    write_targets(folder, options.get<int>("targets"), cell);
    std::cout << folder.string() << '\n';
  }
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "simulated_set", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::write_set);
}
