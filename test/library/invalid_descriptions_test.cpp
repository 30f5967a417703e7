// SPDX-License-Identifier: BSD-3-Clause
// Valid PNG files with wrong descriptions: every field, with every kind of wrong value.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <functional>

#include "library/object_yaml.hpp"
#include "library/png_codec.hpp"
#include "library/quality_numbers.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc::test {
namespace {

constexpr int kWidth = 5, kHeight = 6;  // [px] of each of two views

/// Two views, and all optional fields.
YAML::Node sound() {
  ObjectModel model;
  model.name = model.label = "wrench";
  model.learned_at = 1.7e9;
  model.taught_by = "robot7/left";
  model.metres_per_pixel = 0.001;
  model.min_score = 0.5;
  model.symmetry = 2;
  model.grasp = Grasp{{0.1, 0.2, 0}, {0, 0, 0.6, 0.8}};
  library::for_each_number(model.quality,
                           [](const char*, double& value, double low, double) { value = low; });
  View view;
  view.template_image = cv::Mat::zeros(kHeight, kWidth, CV_8UC3);
  view.map = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(255));
  view.image_size = {640, 480};
  model.views = {view, view};
  return YAML::Load(
      library::write_description(model, {{0, 0, kWidth, kHeight}, {0, kHeight, kWidth, kHeight}}));
}

bool is_refused(const YAML::Node& description, int views = 2) {
  const cv::Mat rgba(views * kHeight, kWidth, CV_8UC4, cv::Scalar::all(255));
  try {
    decode_object(library::encode_png(rgba, "mbncc", YAML::Dump(description)),
                  "/library/wrench.png");
    return false;
  } catch (const FileError& error) {
    EXPECT_FALSE(error.reason().empty());
    return true;
  }
}

using Path = std::vector<std::string>;

std::string text_of(const Path& path) {
  std::string text;
  for (const auto& key : path) text += "/" + key;
  return text;
}

/// The entry of `node` at the path; keys of list entries are numbers.
YAML::Node at(YAML::Node node, const Path& path) {
  for (const auto& key : path) {
    const YAML::Node next = node.IsSequence() ? node[std::stoul(key)] : node[key];
    node.reset(next);
  }
  return node;
}

void expect_refused(const Path& path, const char* lie) {
  YAML::Node description = sound();
  at(description, path) = YAML::Load(lie);
  EXPECT_TRUE(is_refused(description)) << text_of(path) << ": " << lie;
}

void expect_refused_without(Path path) {
  YAML::Node description = sound();
  const std::string key = path.back();
  path.pop_back();
  at(description, path).remove(key);
  EXPECT_TRUE(is_refused(description)) << text_of(path) << " without " << key;
}

struct Number {
  Path path;
  double low, high;  // allowed range
};

std::vector<Number> numbers() {
  std::vector<Number> all = {{{"format"}, 1, kObjectFileVersion},
                             {{"revision"}, 1, 2e9},
                             {{"learned_at"}, 0, 4e9},
                             {{"object_height"}, 0, 1e9},
                             {{"metres_per_pixel"}, 1e-9, 1e9},
                             {{"min_score"}, 1e-9, 1},
                             {{"quality", "symmetry"}, 0, 360}};
  for (const char* i : {"0", "1", "2"}) all.push_back({{"grasp", "position", i}, -1e9, 1e9});
  for (const char* i : {"0", "1", "2", "3"}) all.push_back({{"grasp", "orientation", i}, -1, 1});
  for (const char* view : {"0", "1"}) {
    for (const char* i : {"0", "1", "2"})
      all.push_back({{"views", view, "reference", i}, -1e9, 1e9});
    for (const char* i : {"0", "1"}) all.push_back({{"views", view, "origin", i}, 0, 474});
    for (const char* i : {"0", "1"}) all.push_back({{"views", view, "picture_size", i}, 6, 1e6});
  }
  Quality any;
  library::for_each_number(any, [&all](const char* key, double, double low, double high) {
    all.push_back({{"quality", key}, low, high});
  });
  return all;
}

TEST(InvalidDescriptions, ValidDescriptionsAreAccepted) {
  EXPECT_FALSE(is_refused(sound()));
  for (const char* optional : {"taught_by", "metres_per_pixel", "min_score", "symmetry", "grasp"}) {
    YAML::Node description = sound();
    description.remove(optional);
    EXPECT_FALSE(is_refused(description)) << "without " << optional;
  }
}

TEST(InvalidDescriptions, NumbersMustBeNumbersInRange) {
  for (const auto& number : numbers()) {
    for (const char* lie : {"nan", ".nan", "inf", ".inf", "-.inf", "1e999", "-1e999", "one", "''",
                            "~", "[1]", "[]", "{}", "{a: 1}", "1 2", "1,5", "true"})
      expect_refused(number.path, lie);
    const double width = number.high - number.low;
    for (const double lie : {number.low - 1, number.low - 0.01 * width - 1e-6,
                             number.high + 1 + 0.01 * width, 10 * number.high + width})
      expect_refused(number.path, std::to_string(lie).c_str());
  }
}

TEST(InvalidDescriptions, IntegersMustHaveNoFraction) {
  for (const Path& path : std::initializer_list<Path>{{"format"},
                                                      {"revision"},
                                                      {"quality", "symmetry"},
                                                      {"views", "0", "origin", "0"},
                                                      {"views", "1", "picture_size", "1"},
                                                      {"views", "1", "rectangle", "2"}})
    expect_refused(path, "1.5");
}

TEST(InvalidDescriptions, TextsMustBeTexts) {
  const std::string long_label(201, 'x');
  for (const char* lie :
       {"[a]", "{}", "\"a\\nb\"", "\"a\\u0007b\"", "\"\\x7f\"", long_label.c_str()})
    for (const char* key : {"label", "taught_by"}) expect_refused({key}, lie);
  for (const char* lie : {"perhaps", "2", "[true]", "{}", "~", "''"})
    expect_refused({"enabled"}, lie);
  for (const char* lie : {"EXCELLENT", "good", "''", "[GOOD]", "{}", "~", "0"})
    expect_refused({"quality", "verdict"}, lie);
  for (const char* lie : {"13", "0", "-2", "Round", "[2]", "{}", "~"})
    expect_refused({"symmetry"}, lie);
  for (const char* key : {"reasons", "advice"})
    for (const char* lie : {"text", "{}", "[[a]]", "[{}]", "1"})
      expect_refused({"quality", key}, lie);
  for (const char* lie : {"[a]", "{}"}) expect_refused({"quality", "confusable_with"}, lie);
}

TEST(InvalidDescriptions, ListsMustHaveTheRightLength) {
  const std::vector<std::pair<Path, int>> lists = {
      {{"grasp", "position"}, 3},          {{"grasp", "orientation"}, 4},
      {{"views", "0", "rectangle"}, 4},    {{"views", "0", "origin"}, 2},
      {{"views", "1", "picture_size"}, 2}, {{"views", "1", "reference"}, 3}};
  for (const auto& [path, count] : lists) {
    for (const char* lie : {"[]", "1", "{}", "text", "~"}) expect_refused(path, lie);
    for (const int length : {count - 1, count, count + 1}) {
      YAML::Node description = sound();
      YAML::Node list(YAML::NodeType::Sequence);
      // Copies, because a file that names a node twice is refused for that alone.
      for (int i = 0; i < length; ++i)
        list.push_back(YAML::Clone(at(description, path)[std::min(i, count - 1)]));
      at(description, path) = list;
      EXPECT_EQ(is_refused(description), length != count) << text_of(path) << " of " << length;
    }
  }
}

TEST(InvalidDescriptions, RequiredFieldsMustExist) {
  for (const char* key : {"format", "label", "enabled", "revision", "learned_at", "object_height",
                          "views", "quality"}) {
    expect_refused_without({key});
    if (key != std::string("label")) expect_refused({key}, "~");  // a label may be any text
  }
  for (const char* key : {"verdict", "reasons", "advice", "symmetry", "confusable_with"})
    expect_refused_without({"quality", key});
  for (const char* key : {"rectangle", "origin", "picture_size", "reference"})
    expect_refused_without({"views", "1", key});
  for (const char* key : {"position", "orientation"}) expect_refused_without({"grasp", key});
}

TEST(InvalidDescriptions, ViewsMustLieInTheImageAndInTheirLessons) {
  for (const char* lie : {"[0, 0, 5, 5]", "[0, 0, 5, 7]", "[0, 0, 6, 6]", "[0, 0, 4, 0]",
                          "[0, 0, 0, 6]", "[1, 0, 4, 6]", "[0, 1, 5, 6]", "[0, 6, 5, 6]",
                          "[0, 0, 5, -6]", "[0, 0, 5, 1000000]", "[0, 0, 1000000, 6]"})
    expect_refused({"views", "0", "rectangle"}, lie);
  for (const char* lie : {"[0, 0, 5, 6]", "[0, 5, 5, 6]", "[0, 7, 5, 6]", "[0, 6, 5, 5]",
                          "[0, 6, 5, 7]", "[0, 12, 5, 6]"})
    expect_refused({"views", "1", "rectangle"}, lie);
  for (const char* lie : {"[636, 0]", "[0, 475]", "[1000000, 1000000]"})
    expect_refused({"views", "0", "origin"}, lie);
  for (const char* lie : {"[4, 6]", "[5, 5]", "[0, 0]", "[-640, 480]"})
    expect_refused({"views", "0", "picture_size"}, lie);
  for (const char* lie : {"[]", "text", "{}", "1", "[1]", "[{}]", "[~]"})
    expect_refused({"views"}, lie);
}

TEST(InvalidDescriptions, TheNumberOfViewsIsLimited) {
  YAML::Node description = sound();
  const auto add_view = [&description](int number) {
    YAML::Node view = YAML::Clone(description["views"][0]);
    view["rectangle"][1] = number * kHeight;
    description["views"].push_back(view);
  };
  int views = 2;
  while (views < static_cast<int>(library::kMaxViews)) add_view(views++);
  EXPECT_FALSE(is_refused(description, views));
  add_view(views++);
  EXPECT_TRUE(is_refused(description, views));
}

TEST(InvalidDescriptions, AGraspMustBeAUnitQuaternion) {
  for (const char* lie : {"[0, 0, 0, 0]", "[0, 0, 0, 2]", "[1, 1, 0, 0]", "[0, 0, 0.6, 0.7]"})
    expect_refused({"grasp", "orientation"}, lie);
  for (const char* lie : {"text", "[1, 2, 3]", "1"}) expect_refused({"grasp"}, lie);
}

}  // namespace
}  // namespace mbncc::test
