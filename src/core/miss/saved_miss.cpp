// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/miss/saved_miss.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "library/file_io.hpp"
#include "library/png_codec.hpp"
#include "mbncc/config/field.hpp"
#include "mbncc/image_limits.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kLargestFile = std::size_t{512} << 20;  // [bytes]
constexpr const char* kVersionKey = "mbncc_miss";
constexpr const char* kNoText = "";

YAML::Binary binary(const std::vector<std::uint8_t>& bytes) {
  return {bytes.data(), bytes.size()};
}

std::vector<std::uint8_t> bytes_of(const YAML::Node& node) {
  const auto data = node.as<YAML::Binary>();
  return {data.data(), data.data() + data.size()};
}

std::vector<std::uint8_t> encode(const cv::Mat& image) {
  cv::Mat rgba;
  cv::cvtColor(image, rgba, cv::COLOR_BGR2RGBA);
  return library::encode_png(rgba, kVersionKey, kNoText, ImageLimits::hold);
}

cv::Mat decode(const std::vector<std::uint8_t>& bytes) {
  library::PngReader reader(bytes, kVersionKey, ImageLimits::hold);
  cv::Mat rgba(reader.size(), CV_8UC4), image;
  for (int y = 0; y < rgba.rows; ++y) reader.read_row(rgba.ptr(y));
  reader.finish();
  cv::cvtColor(rgba, image, cv::COLOR_RGBA2BGR);
  return image;
}

SavedMiss parse(const YAML::Node& root, const std::string& path) {
  SavedMiss miss;
  const int version = root[kVersionKey].as<int>();
  if (version > kMissFileVersion)
    throw FileError(path, "written by a newer version of mbncc; use that one");
  miss.lines = root["explanation"].as<std::vector<std::string>>();
  miss.place = {root["place"][0].as<double>(), root["place"][1].as<double>()};
  miss.names = root["names"].as<std::vector<std::string>>();
  const auto rows = field_rows(miss.search);
  for (const auto& setting : root["settings"])
    assign_field(rows, setting.first.as<std::string>(), setting.second.as<std::string>());
  miss.image = decode(bytes_of(root["picture"]));
  for (const auto& object : root["objects"]) {
    const auto name = object.first.as<std::string>();
    miss.objects.push_back(std::make_shared<ObjectModel>(
        decode_object(bytes_of(object.second), name + kObjectFileEnding)));
  }
  return miss;
}

}  // namespace

std::vector<Explanation> explain(const SavedMiss& miss) {
  return explain_place(miss.objects, miss.search, miss.image, miss.place, miss.names);
}

std::vector<std::string> lines_of(const std::vector<Explanation>& explanations, std::size_t most) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(most, explanations.size()); ++i)
    for (const auto& line : lines_of(explanations[i])) lines.push_back(line);
  return lines;
}

void write_miss(const std::string& path, const SavedMiss& miss) {
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << kVersionKey << YAML::Value << kMissFileVersion;
  out << YAML::Comment("run it again: mbncc replay FILE");
  out << YAML::Key << "explanation" << YAML::Value << miss.lines;
  out << YAML::Key << "place" << YAML::Value << YAML::Flow
      << std::vector<double>{miss.place.x, miss.place.y};
  out << YAML::Key << "names" << YAML::Value << YAML::Flow << miss.names;
  out << YAML::Key << "settings" << YAML::Value << YAML::BeginMap;
  SearchConfig search = miss.search;
  for (const auto& row : field_rows(search))
    out << YAML::Key << row.info.name << YAML::Value << row.value;
  out << YAML::EndMap;
  out << YAML::Key << "picture" << YAML::Value << binary(encode(miss.image));
  out << YAML::Key << "objects" << YAML::Value << YAML::BeginMap;
  for (const auto& object : miss.objects)
    out << YAML::Key << object->name << YAML::Value << binary(encode_object(*object));
  out << YAML::EndMap << YAML::EndMap << YAML::Newline;
  const auto slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::string text = out.c_str();
  library::write_file_atomically(folder, name, {text.begin(), text.end()});
}

SavedMiss read_miss(const std::string& path) {
  const auto content = library::read_regular_file(path, kLargestFile);
  const std::string text(content.bytes.begin(), content.bytes.end());
  if (text.rfind(kVersionKey, 0) != 0)
    throw FileError(
        path,
        "not a saved miss; give a file written by 'Save this miss' or 'mbncc explain --save'");
  try {
    return parse(YAML::Load(text), path);
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& error) {
    throw FileError(path, std::string("a damaged saved miss: ") + error.what());
  }
}

}  // namespace mbncc
