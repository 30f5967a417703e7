// The paper's matching experiments (doi 10.1177/1687814017728839, Figs. 12 to 15) in the simulated
// cell: MB-NCC against PP-NCC with incircle and excircle, at the true place of the object.
#include <filesystem>
#include <iostream>
#include <opencv2/imgproc.hpp>

#include "common/program.hpp"
#include "common/table.hpp"
#include "mbncc/geometry.hpp"
#include "mbncc/polar.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@out   |   | folder for rotation.csv and backgrounds.csv }"
    "{help h |   | this text }";

constexpr double kDiameter = 110;             // [px]
constexpr double kElongations[] = {1, 2, 4};  // the paper: square, irregular, elongated
constexpr int kBackgrounds = 6;
const Pose2D kPlace{320, 240, 0};

/// A template in polar form, and where its centre lies in the learning picture.
struct Variant {
  cv::Point2d centre;
  PolarTemplate object;
};

cv::Mat disc(cv::Size size, const Circle& circle) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  cv::circle(mask, circle.centre, cvRound(circle.radius), 255, cv::FILLED);
  return mask;
}

Variant variant(const cv::Mat& grey, const cv::Mat& region, const Circle& circle) {
  return {circle.centre, PolarTemplate(grey, region, circle.centre, PolarGrid::of(circle.radius))};
}

/// MB-NCC, PP-NCC with incircle, PP-NCC with excircle.
std::vector<Variant> variants(const cv::Mat& grey, const cv::Mat& map) {
  const Circle outer = excircle(map), inner = incircle(map);
  return {variant(grey, map, outer), variant(grey, disc(map.size(), inner), inner),
          variant(grey, disc(map.size(), outer), outer)};
}

cv::Mat grey_scene(std::uint64_t platform, const sim::Placed& placed) {
  sim::SceneConfig config;
  config.seed = platform;
  cv::Mat grey;
  cv::cvtColor(sim::Scene(config).render({placed}, platform), grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// Similarities at the true place for every rotation of the template.
std::vector<double> by_rotation(const Variant& variant, const cv::Mat& grey) {
  return variant.object.similarities(polar_image(grey, variant.centre, variant.object.grid()));
}

double at_degrees(const std::vector<double>& similarities, double degrees) {
  const auto count = similarities.size();
  return similarities[static_cast<std::size_t>(cvRound(degrees / 360 * count)) % count];
}

struct Results {
  Table rotation{{"elongation", "degrees", "mbncc", "incircle", "excircle"}, {}};
  Table backgrounds{{"elongation", "background", "mbncc", "incircle", "excircle"}, {}};
};

/// The object is learned on one platform and looked at on others.
void compare(double elongation, Results& results) {
  sim::Placed placed;
  placed.object = {7, kDiameter, elongation};
  placed.pose = kPlace;
  const cv::Mat map = sim::Scene().true_map(placed);
  const auto templates = variants(grey_scene(1, placed), map);
  for (int background = 2; background < 2 + kBackgrounds; ++background) {
    const cv::Mat grey = grey_scene(static_cast<std::uint64_t>(background), placed);
    std::vector<std::string> row{to_text(elongation, 1), std::to_string(background)};
    std::vector<std::vector<double>> curves;
    for (const auto& one : templates) {
      curves.push_back(by_rotation(one, grey));
      row.push_back(to_text(at_degrees(curves.back(), 0), 4));
    }
    results.backgrounds.rows.push_back(row);
    if (background > 2) continue;
    for (int degrees = 0; degrees <= 200; ++degrees) {
      results.rotation.rows.push_back({to_text(elongation, 1), std::to_string(degrees)});
      for (const auto& curve : curves)
        results.rotation.rows.back().push_back(to_text(at_degrees(curve, degrees), 4));
    }
  }
}

void benchmark(const cv::CommandLineParser& options) {
  const fs::path out = options.get<std::string>("@out");
  Results results;
  for (const double elongation : kElongations) compare(elongation, results);
  fs::create_directories(out);
  save_csv((out / "rotation.csv").string(), results.rotation);
  save_csv((out / "backgrounds.csv").string(), results.backgrounds);
  write_markdown(std::cout, results.backgrounds);
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "paper_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
