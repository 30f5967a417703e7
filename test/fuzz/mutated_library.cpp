// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/mutated_library.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "library/object_yaml.hpp"
#include "library/png_codec.hpp"
#include "mbncc/image_limits.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/searched_map.hpp"

namespace mbncc::fuzz {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

void write(const std::string& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  int any(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  template <class Choices>
  auto one_of(const Choices& choices) {
    return choices[static_cast<std::size_t>(any(static_cast<int>(std::size(choices))))];
  }

  /// A valid object, mostly with one to three views of unusual shapes.
  ObjectModel model() {
    ObjectModel model;
    model.name = "mutant";
    model.label = any(4) == 0 ? "M\xc3\xbcller's \"part\": [1]" : "mutant";
    model.revision = 1 + static_cast<std::uint32_t>(any(3));
    model.enabled = any(10) != 0;
    model.symmetry = any(4) == 0 ? std::make_optional(any(5)) : std::nullopt;
    if (any(6) == 0) model.min_score = (1 + any(100)) / 100.0;
    if (any(6) == 0) model.object_height = any(11);
    if (any(6) == 0) model.metres_per_pixel = std::pow(10.0, -any(9));
    if (any(6) == 0) model.grasp = Grasp{{0, 0, 0.1 * any(90)}, {0, 0, 0.6, 0.8}};
    for (int views = any(4) == 0 ? 2 + any(2) : 1; views > 0; --views)
      model.views.push_back(view());
    if (model.symmetry == 5) model.symmetry = 6;
    return model;
  }

  View view() {
    const auto border = static_cast<test::Border>(any(test::kBorders));
    const auto shape = static_cast<test::MapShape>(any(test::kMapShapes));
    const int margin = any(3) == 0 ? 0 : any(9);
    View view = test::object_of(test::map_of(shape, map_size(), random_()), border, margin, any(30),
                                random_())
                    ->views.front();
    const int limits = any(8);
    if (limits < 5) fit_into_image(view);
    if (limits == 6) view.image_size = {ImageLimits::kMostSide, 3900};
    if (any(8) == 0) view.reference = far_reference();
    return view;
  }

  std::string text(const std::string& sound) {
    std::string text = sound;
    switch (any(6)) {
      case 0:
        return with_byte(text);
      case 1:
        return with_alias(text);
      case 2:
        return with_line(text);
      default:
        for (int changes = 1 + any(2); changes > 0; --changes) text = with_value(text);
        return text;
    }
  }

  Bytes bytes(Bytes bytes) {
    if (any(3) == 0) bytes.resize(static_cast<std::size_t>(any(static_cast<int>(bytes.size()))));
    for (int changes = any(4); changes > 0 && !bytes.empty(); --changes)
      bytes[static_cast<std::size_t>(any(static_cast<int>(bytes.size())))] =
          static_cast<std::uint8_t>(random_());
    return bytes;
  }

  /// Name of a file that may be taken for an object's file, or for one in the trash.
  std::string name() {
    static const std::vector<std::string> names{"mutant.png",
                                                "victim.1.png",
                                                "keeper.png.png",
                                                "Victim.png",
                                                "m.png",
                                                "mutant .png",
                                                "m\xc3\xbcll.png",
                                                "1mutant.png",
                                                ".hidden.png",
                                                ".png",
                                                "mutant.PNG",
                                                "a\nb.png",
                                                "..png",
                                                ".mbncc-tmp-mutant",
                                                "mutant",
                                                ".trash/victim.4294967295.png",
                                                ".trash/victim.2000000000.png",
                                                ".trash/victim.0.png",
                                                ".trash/victim.1.png",
                                                ".trash/mutant.7.2.png",
                                                ".quarantine/mutant.png",
                                                std::string(64, 'n') + ".png",
                                                std::string(65, 'n') + ".png",
                                                std::string(200, 'n') + ".png"};
    return one_of(names);
  }

 private:
  cv::Size map_size() {
    constexpr int kMostArea = 3000;
    const auto side = [&] { return any(12) == 0 ? 1 + any(2000) : 1 + any(26); };
    cv::Size size(side(), 1);
    size.height = std::min(side(), std::max(1, kMostArea / size.width));
    return size;
  }

  static void fit_into_image(View& view) {
    const cv::Size image(kImageWidth, kImageHeight);
    if (view.map.cols > image.width || view.map.rows > image.height) return;
    view.image_size = image;
    view.origin.x = std::min(view.origin.x, image.width - view.map.cols);
    view.origin.y = std::min(view.origin.y, image.height - view.map.rows);
  }

  Pose2D far_reference() {
    constexpr double kPlaces[] = {0, -1, 0.5, 5000, 32768, -kFarthestReference, kFarthestReference};
    constexpr double kAngles[] = {0, 3.2, -100, 1e9};
    return {one_of(kPlaces), one_of(kPlaces), one_of(kAngles)};
  }

  std::string with_byte(std::string text) {
    text[static_cast<std::size_t>(any(static_cast<int>(text.size())))] =
        static_cast<char>(1 + any(255));
    return text;
  }

  std::string with_alias(std::string text) {
    const auto at = text.find("advice:");
    std::string list = "advice: [&a " + std::string(static_cast<std::size_t>(any(32000)), 'a');
    for (int aliases = any(9000); aliases > 0; --aliases) list += ",*a";
    text.replace(at, text.find("symmetry:", at) - at, list + "]\n  ");
    return text.size() < library::PngLimits::kMaxText
               ? text
               : with_line(text.substr(0, library::PngLimits::kMaxText / 2));
  }

  std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    return text;
  }

  std::string with_line(const std::string& text) {
    auto lines = lines_of(text);
    const auto place = [&] { return lines.begin() + any(static_cast<int>(lines.size())); };
    const int kind = any(3);
    if (kind == 0)
      lines.erase(place());
    else if (kind == 1)
      lines.insert(place(), one_of(lines));
    else
      std::iter_swap(place(), place());
    return joined(lines);
  }

  /// Replaces the value in a line `key: value`, or a number in a list.
  std::string with_value(const std::string& text) {
    static const std::vector<std::string> values{
        "0",     "-1",   "1",      "2",     "15",           "16384",        "16385",        "65500",
        "1e6",   "1e9",  "-1e9",   "1e308", "1e-300",       "2147483647",   "4294967295",   "nan",
        ".inf",  "~",    "[]",     "{}",    "true",         "false",        "\"\"",         "none",
        "round", "GOOD", "[1, 2]", "0.001", "\"\\u202Ea\"", "\"\\x1B[2J\"", "!!binary aGk="};
    auto lines = lines_of(text);
    std::string& line = lines[static_cast<std::size_t>(any(static_cast<int>(lines.size())))];
    const auto list = line.find('['), colon = line.find(": ");
    if (list != std::string::npos && any(4) != 0) {
      auto begin = list + 1;
      for (int skip = any(4); skip > 0 && line.find(", ", begin) != std::string::npos; --skip)
        begin = line.find(", ", begin) + 2;
      line.replace(begin, line.find_first_of(",]", begin) - begin, one_of(values));
    } else if (colon != std::string::npos) {
      line.replace(colon + 2, std::string::npos, one_of(values));
    }
    return joined(lines);
  }

  std::mt19937 random_;
};

/// Stacked views with the map in alpha, drawn like encode_object() does whatever the description
/// says.
cv::Mat drawn(const ObjectModel& model, std::vector<cv::Rect>& rectangles) {
  cv::Size canvas;
  for (const auto& view : model.views) {
    rectangles.emplace_back(cv::Point(0, canvas.height), view.map.size());
    canvas = {std::max(canvas.width, view.map.cols), canvas.height + view.map.rows};
  }
  cv::Mat rgba = cv::Mat::zeros(canvas, CV_8UC4);
  for (std::size_t i = 0; i < model.views.size(); ++i) {
    cv::Mat target = rgba(rectangles[i]), channels[4];
    cv::split(model.views[i].template_image, channels);
    channels[3] = model.views[i].map;
    cv::merge(channels, 4, target);
  }
  return rgba;
}

Bytes object_bytes(Mutator& mutator) {
  const ObjectModel model = mutator.model();
  std::vector<cv::Rect> rectangles;
  cv::Mat rgba = drawn(model, rectangles);
  std::string text = library::write_description(model, rectangles);
  const int kind = mutator.any(16);
  if (kind < 6) text = mutator.text(text);
  if (kind == 6) rgba.at<cv::Vec4b>(0, 0)[3] = static_cast<uchar>(mutator.any(256));
  if (kind == 7) rgba = rgba.rowRange(0, 1 + mutator.any(rgba.rows)).clone();
  Bytes bytes;
  try {
    bytes = library::encode_png(rgba, "mbncc", text);
  } catch (const std::invalid_argument&) {  // text that PNG cannot contain
    bytes = {text.begin(), text.end()};
  }
  return kind == 8 ? mutator.bytes(bytes) : bytes;
}

void add_mutant(const std::string& folder, Mutator& mutator, int number) {
  const bool odd_name = mutator.any(4) == 0;
  const std::string name = odd_name ? mutator.name() : "mutant" + std::to_string(number) + ".png";
  const std::string path = folder + "/" + name;
  std::error_code ignored;
  const int kind = mutator.any(40);
  fs::create_directories(fs::path(path).parent_path(), ignored);
  fs::remove_all(path, ignored);
  if (kind == 0)
    fs::create_directory(path, ignored);
  else if (kind == 1)
    fs::create_symlink(folder + "/victim.png", path, ignored);
  else if (kind == 2)
    ::mkfifo(path.c_str(), 0644);
  else
    write(path, object_bytes(mutator));
  // A file changed in the last seconds would not be quarantined yet.
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::minutes(1), ignored);
}

/// Puts the library's own folders and files into a state in which no library leaves them.
void disturb(const std::string& folder, Mutator& mutator) {
  constexpr const char* kInner[] = {".trash", ".quarantine", ".lock"};
  const std::string inner = folder + "/" + mutator.one_of(kInner);
  std::error_code ignored;
  fs::remove_all(inner, ignored);
  const int kind = mutator.any(3);
  if (kind == 0)
    fs::create_symlink(folder, inner, ignored);
  else if (kind == 1)
    fs::create_directory(inner, ignored);
  else
    std::ofstream(inner) << "?";
}

}  // namespace

void make_mutated_library(const std::string& folder, unsigned seed) {
  Mutator mutator(seed);
  auto sound = test::object_of(test::map_of(test::MapShape::kDisc, {19, 15}, 1),
                               test::Border::kNone, 4, 20, 7);
  sound->name = sound->label = kSound;
  View& view = sound->views.front();
  view.image_size = {kImageWidth, kImageHeight};
  cv::GaussianBlur(view.template_image, view.template_image, {}, 2);
  view.template_image = 4 * (view.template_image - cv::Scalar::all(104));
  view.template_image.setTo(cv::Scalar(90, 100, 110), view.map == 0);
  write(folder + "/" + kSound + ".png", encode_object(*sound));
  make_mutants(folder, seed + 1000000);
  if (mutator.any(12) == 0) disturb(folder, mutator);
}

void make_mutants(const std::string& folder, unsigned seed) {
  Mutator mutator(seed);
  const int mutants = 1 + mutator.any(2);
  for (int number = 0; number < mutants; ++number) add_mutant(folder, mutator, number);
}

}  // namespace mbncc::fuzz
