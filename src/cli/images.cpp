// SPDX-License-Identifier: BSD-3-Clause
#include "cli/images.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <system_error>
#include <vector>

#include "cli/image_header.hpp"
#include "mbncc/error.hpp"
#include "mbncc/image_limits.hpp"
#include "mbncc/jpeg_damage.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc::cli {
namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} << 20;

std::string errno_text(int code) {
  return std::generic_category().message(code);
}

std::string remedy_for(const std::string& unwritable) {
  const auto folder = std::filesystem::path(unwritable).parent_path();
  return folder.empty() || std::filesystem::exists(folder)
             ? "; check disk space and permissions"
             : "; create the folder or choose another one";
}

std::vector<std::uint8_t> read_bytes(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw FileError(path, "there is no such file");
  if (std::filesystem::is_directory(status))
    throw FileError(path, "a folder; give the images in it");
  if (!std::filesystem::is_regular_file(status)) throw FileError(path, "not a regular file");
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw FileError(path, error.message());
  if (size == 0) throw FileError(path, "the file is empty");
  if (size > kMaxFileBytes) throw FileError(path, "larger than 256 MB");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(size);
  if (!file ||
      !file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    throw FileError(path, "cannot be read: " + errno_text(errno));
  return bytes;
}

void write_bytes(const std::string& file, const std::vector<std::uint8_t>& bytes,
                 const std::string& path) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) return;
  const std::string reason = "cannot be written: " + errno_text(errno) + remedy_for(path);
  std::error_code ignored;
  if (file != path) std::filesystem::remove(file, ignored);
  throw FileError(path, reason);
}

void check_header(const ImageHeader& header, const std::string& path) {
  if (std::uint64_t{header.width} * header.height > std::uint64_t{ImageLimits::kMostPixels})
    throw FileError(path, "the image has more than 64 million pixels; scale it down");
  if (std::max(header.width, header.height) > std::uint32_t{ImageLimits::kMostSide})
    throw FileError(path, "the image has more than 16384 pixels a side; scale it down");
  if (header.bits > 8)
    throw FileError(path, std::to_string(header.bits) +
                              " bits per channel; convert it to 8 bits, with the scaling that "
                              "suits the camera");
  if (!header.complete) throw FileError(path, "the file is truncated");
}

// Grippers are calibrated to the sensor's rows and columns, so the orientation is not applied.
void tell_of_orientation(const ImageHeader& header, const std::string& path) {
  if (header.orientation != 1)
    std::cerr << "mbncc: warning: " << path << ": its EXIF orientation (" << header.orientation
              << ") is not applied; coordinates are those of the sensor's image\n";
}

cv::Mat decode(const std::string& path) {
  const auto bytes = read_bytes(path);
  cv::Mat image;
  try {
    const ImageHeader header = read_image_header(bytes);
    check_header(header, path);
    if (const std::string damage = jpeg_damage(bytes); !damage.empty())
      throw FileError(path, "the image is damaged (" + damage + "); copy it again");
    image = cv::imdecode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    tell_of_orientation(header, path);
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& error) {
    throw FileError(path, error.what());
  }
  if (image.empty()) throw FileError(path, "the image is damaged");
  return image;
}

bool is_colourful(const cv::Mat& image) {
  constexpr int kSpread = 24;      // [grey levels] between the channels of a pixel
  constexpr double kShare = 0.01;  // [0..1] fraction of the pixels
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  const cv::Mat most = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  const cv::Mat least = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  return cv::countNonZero(most - least > kSpread) > kShare * static_cast<double>(image.total());
}

// True for a few grey values, as in a drawing, or for black and white except for smooth edges and
// JPEG noise.
bool is_drawn(const cv::Mat& grey) {
  constexpr int kFew = 16;
  constexpr int kBlack = 64, kWhite = 192;  // [grey levels] black is below, white at or above
  constexpr double kShare = 0.8;            // [0..1] fraction of the pixels
  std::array<int, 256> counts{};
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) ++counts[grey.at<uchar>(y, x)];
  const auto unused = std::count(counts.begin(), counts.end(), 0);
  const int between = std::accumulate(counts.begin() + kBlack, counts.begin() + kWhite, 0);
  return unused >= 256 - kFew || between <= (1 - kShare) * static_cast<double>(grey.total());
}

/// Reports a file in the middle of the path by name; the system's error message does not contain
/// it.
void refuse_file_in(const std::filesystem::path& folder) {
  std::filesystem::path walked;
  std::error_code ignored;
  for (const auto& part : folder) {
    walked /= part;
    if (std::filesystem::is_regular_file(walked, ignored))
      throw FileError(walked.string(), "is a file; give a folder");
  }
}

}  // namespace

cv::Mat read_image(const std::string& path) {
  return decode(path);
}

cv::Mat read_map(const std::string& path) {
  const cv::Mat image = decode(path);
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  if (is_colourful(image) || !is_drawn(grey))
    throw FileError(path,
                    "a photograph, not a map; give an image that is white on the object and "
                    "black elsewhere");
  return grey > 127;
}

void refuse_to_replace(const std::string& path, const std::vector<std::string>& inputs) {
  if (is_object_file(path))
    throw FileError(path, "is a learned object and is not replaced; choose another name or folder");
  std::error_code ignored;
  for (const auto& input : inputs)
    if (std::filesystem::equivalent(path, input, ignored))
      throw FileError(path, "is an input and is not replaced; choose another name or folder");
}

void write_image(const std::string& path, const cv::Mat& image,
                 const std::vector<std::string>& inputs) {
  namespace fs = std::filesystem;
  refuse_to_replace(path, inputs);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  refuse_file_in(fs::path(path).parent_path());
  std::error_code error;
  const bool device = fs::exists(path, error) && !fs::is_regular_file(path, error);
  // Writes a temporary file and renames it, so that an old file is kept until the new one is
  // complete.
  const std::string unfinished = device ? path : path + ".part";
  write_bytes(unfinished, bytes, path);
  if (device) return;
  fs::rename(unfinished, path, error);
  if (!error) return;
  const std::string reason = "cannot be written: " + error.message() + remedy_for(path);
  fs::remove(unfinished, error);
  throw FileError(path, reason);
}

void make_output_folder(const std::string& folder) {
  refuse_file_in(folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw FileError(folder, "cannot be created: " + error.message());
}

}  // namespace mbncc::cli
