// SPDX-License-Identifier: BSD-3-Clause
// The paper's matching experiments (doi 10.1177/1687814017728839, Figs. 12 to 16) in the simulated
// cell: MB-NCC against PP-NCC with incircle and excircle, at the true position of the object, and
// at every position of an image that also shows a piece of wastepaper.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "common/program.hpp"
#include "common/table.hpp"
#include "mbncc/geometry.hpp"
#include "mbncc/polar.hpp"
#include "mbncc/sim/scene.hpp"
#include "paper/wastepaper.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@out   |   | folder for the figures' CSV files and images }"
    "{help h |   | this text }";

constexpr double kDiameter = 110;             // [px]
constexpr double kElongations[] = {1, 2, 4};  // the paper: square, irregular, elongated
constexpr int kBackgrounds = 6;
constexpr const char* kVariants[] = {"mbncc", "incircle", "excircle"};
constexpr int kStep = 2;  // [px] in the half-size image
const cv::Point2d kWastepaper{450, 230};
const Pose2D kPlace{320, 240, 0};

/// A template in polar form, and the position of its centre in the learning image.
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

/// Similarities at the true position for every rotation of the template.
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

/// The object is learned on one platform and compared on others.
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

/// Best similarity over all rotations at every kStep-th pixel of a half-size image.
cv::Mat best_by_place(const Variant& variant, const cv::Mat& grey) {
  cv::Mat scores(grey.rows / kStep, grey.cols / kStep, CV_32FC1);
  for (int row = 0; row < scores.rows; ++row)
    for (int column = 0; column < scores.cols; ++column) {
      const cv::Point2d place(column * kStep, row * kStep);
      const auto curve =
          variant.object.similarities(polar_image(grey, place, variant.object.grid()));
      scores.at<float>(row, column) =
          static_cast<float>(*std::max_element(curve.begin(), curve.end()));
    }
  return scores;
}

/// Largest score within `radius` cells of a position. It is never NaN, because the position lies in
/// the image.
double peak_near(const cv::Mat& scores, cv::Point2d place, double radius, bool inside) {
  cv::Mat mask(scores.size(), CV_8UC1, cv::Scalar(inside ? 0 : 255));
  cv::circle(mask, place, cvRound(radius), cv::Scalar(inside ? 255 : 0), cv::FILLED);
  double best = 0;
  cv::minMaxLoc(scores, nullptr, &best, nullptr, nullptr, mask);
  return best;
}

cv::Mat half_grey(const cv::Mat& image) {
  cv::Mat grey, half;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::pyrDown(grey, half);
  return half;
}

/// Figs. 14c and 16: the rotated object and the wastepaper on a platform that was not used for
/// learning.
void compare_places(const fs::path& out) {
  sim::Placed placed;
  placed.object = {7, kDiameter, kElongations[2]};
  placed.pose = kPlace;
  const sim::Scene learned;
  cv::Mat half_map;
  cv::resize(learned.true_map(placed), half_map, {}, 0.5, 0.5, cv::INTER_AREA);
  const auto templates = variants(half_grey(learned.render({placed}, 1)), half_map > 127);
  sim::SceneConfig config;
  config.seed = 2;
  placed.pose = {190, 250, 0.7};
  cv::Mat image = sim::Scene(config).render({placed}, 2);
  draw_wastepaper(image, kWastepaper, kDiameter, 3);
  cv::imwrite((out / "wastepaper.png").string(), image);
  const double cells = 1 / (2.0 * kStep), radius = kDiameter / 2 * cells;
  Table table{{"variant", "object", "wastepaper", "elsewhere"}, {}};
  for (std::size_t i = 0; i < templates.size(); ++i) {
    const cv::Mat scores = best_by_place(templates[i], half_grey(image));
    cv::Mat levels;
    scores.convertTo(levels, CV_8UC1, 255);
    cv::imwrite((out / ("scores_" + std::string(kVariants[i]) + ".png")).string(), levels);
    const cv::Point2d object = placed.pose.position() * cells;
    table.rows.push_back({kVariants[i], to_text(peak_near(scores, object, radius, true), 4),
                          to_text(peak_near(scores, kWastepaper * cells, radius, true), 4),
                          to_text(peak_near(scores, object, radius, false), 4)});
  }
  save_csv((out / "wastepaper.csv").string(), table);
  write_markdown(std::cout, table);
  std::cout << '\n';
}

void benchmark(const cv::CommandLineParser& options) {
  const fs::path out = output_folder(options.get<std::string>("@out"));
  Results results;
  for (const double elongation : kElongations) compare(elongation, results);
  compare_places(out);
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
