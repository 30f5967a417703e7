// SPDX-License-Identifier: BSD-3-Clause
#include "cli/evaluate/evaluation_page.hpp"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <utility>

#include "cli/images.hpp"
#include "mbncc/drawing.hpp"
#include "mbncc/error.hpp"
#include "mbncc/matching/overlay.hpp"

namespace mbncc::cli {
namespace {

constexpr double kArm = 14;  // [px] arm length of the cross at a true position

std::string number(double value, int digits) {
  if (std::isnan(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string percent(double part) {
  return std::isnan(part) ? "-" : number(100 * part, 1) + " %";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

Marking missed_marking(const TrueInstance& missed) {
  Marking marking;
  marking.pose = missed.pose;
  const cv::Point2f at(missed.pose.position());
  const auto arm = static_cast<float>(kArm);
  marking.outlines = {{at + cv::Point2f(-arm, -arm), at + cv::Point2f(arm, -arm),
                       at + cv::Point2f(arm, arm), at + cv::Point2f(-arm, arm)}};
  marking.colour = colour_of(Confidence::kBad);
  marking.caption = "missed " + missed.name;
  return marking;
}

}  // namespace

std::vector<std::string> sentences_of(const Figures& figures) {
  const auto of = [](int part, int whole) {
    return " (" + std::to_string(part) + " of " + std::to_string(whole) + ")";
  };
  const int reported = figures.right + figures.wrong,
            graspable = figures.right_graspable + figures.wrong_graspable;
  std::vector<std::string> sentences = {
      std::to_string(figures.images) + " images with " + std::to_string(figures.instances) +
          " instances, searched in " + number(figures.seconds, 1) + " s",
      "recall: " + percent(figures.recall()) + of(figures.right, figures.instances) +
          ", graspable " + percent(figures.recall_graspable()) +
          of(figures.right_graspable, figures.instances),
      "precision: " + percent(figures.precision()) + of(figures.right, reported) + ", graspable " +
          percent(figures.precision_graspable()) + of(figures.right_graspable, graspable) + ", " +
          std::to_string(figures.wrong_graspable) + " wrong grasps",
      "errors of right detections: position " + number(quantile(figures.place_errors, 0.5), 2) +
          " px median, " + number(quantile(figures.place_errors, 0.95), 2) + " px at 95 %; angle " +
          number(to_degrees(quantile(figures.angle_errors, 0.5)), 2) + " deg median, " +
          number(to_degrees(quantile(figures.angle_errors, 0.95)), 2) + " deg at 95 %"};
  if (figures.unreadable > 0)
    sentences.push_back(std::to_string(figures.unreadable) + " images could not be read");
  return sentences;
}

EvaluationPage::EvaluationPage(std::string folder, std::vector<std::string> inputs)
    : folder_(std::move(folder)), inputs_(std::move(inputs)) {
  if (!folder_.empty()) make_output_folder(folder_);
}

void EvaluationPage::add(const std::string& image_path, const cv::Mat& image,
                         const Comparison& comparison) {
  if (folder_.empty() || (comparison.missed.empty() && comparison.wrong.empty())) return;
  std::vector<Match> found = comparison.right;
  found.insert(found.end(), comparison.wrong.begin(), comparison.wrong.end());
  std::vector<Marking> markings;
  for (const auto& missed : comparison.missed) markings.push_back(missed_marking(missed));
  const std::string file = "image_" + std::to_string(++images_) + ".png";
  write_image(folder_ + "/" + file, draw_markings(draw_matches(image, found), markings), inputs_);
  rows_ += "<figure><img src=\"" + file + "\" width=\"640\"><figcaption>" + escaped(image_path) +
           ": " + std::to_string(comparison.missed.size()) + " missed, " +
           std::to_string(comparison.wrong.size()) + " wrong";
  for (const auto& match : comparison.wrong)
    rows_ += "; wrong: " + match.name + " " + number(match.score, 2) +
             (match.graspable ? ", GRASPABLE" : ", not graspable");
  rows_ += "</figcaption></figure>\n";
}

std::string EvaluationPage::finish(const Figures& figures) const {
  if (folder_.empty()) return "";
  const std::string path = folder_ + "/index.html";
  std::ofstream page(path);
  page
      << "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>mbncc evaluate</title>\n"
         "<style>body{font-family:sans-serif;max-width:90em;margin:2em}figure{display:inline-block;"
         "margin:.5em}</style>\n<h1>Evaluation</h1><ul>\n";
  for (const auto& sentence : sentences_of(figures)) page << "<li>" << sentence << "</li>\n";
  page << "</ul>\n<h2>Misses and wrong detections</h2>\n"
       << (rows_.empty() ? "<p>Nothing.</p>\n" : rows_) << "</html>\n";
  if (!page.flush()) throw FileError(path, "cannot be written; check disk space and permissions");
  return path;
}

}  // namespace mbncc::cli
