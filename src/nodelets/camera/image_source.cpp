// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/image_source.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <system_error>

#include "mbncc/error.hpp"
#include "mbncc/jpeg_damage.hpp"

namespace mbncc::nodelets {
namespace {

namespace fs = std::filesystem;
namespace logging = cv::utils::logging;

/// Whether the source is the number of a device, such as "0" or "12".
bool is_index(const std::string& source) {
  return source.size() < 6 && std::all_of(source.begin(), source.end(),
                                          [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool is_image_file(const fs::path& path) {
  static const std::vector<std::string> kExtensions{".png", ".jpg",  ".jpeg", ".bmp",
                                                    ".tif", ".tiff", ".pgm",  ".ppm"};
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::vector<std::string> images_in(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (is_image_file(entry->path())) paths.push_back(entry->path().string());
  if (error) throw FileError(folder, error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<std::uint8_t> content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Lists the devices, as in "there is /dev/video0, /dev/video2", for the error message about a
/// mistyped device.
std::string devices_here() {
  std::vector<std::string> devices;
  std::error_code error;
  for (fs::directory_iterator entry("/dev", error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().rfind("video", 0) == 0)
      devices.push_back(entry->path().string());
  std::sort(devices.begin(), devices.end());
  std::string sentence = devices.empty() ? "there is no /dev/video*" : "there is ";
  for (const auto& device : devices) sentence += (&device == &devices[0] ? "" : ", ") + device;
  return sentence;
}

bool is_stream(const std::string& source) {
  return source.find("://") != std::string::npos;
}

/// Silences OpenCV while it exists, because OpenCV's backends write the address of a stream that
/// cannot be opened to standard error.
class QuietOpenCv {
 public:
  QuietOpenCv() : before_(logging::setLogLevel(logging::LOG_LEVEL_SILENT)) {}
  ~QuietOpenCv() { logging::setLogLevel(before_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  const logging::LogLevel before_;
};

/// The images of a folder in the order of their names; the folder is read again for every loop.
class FolderSource : public ImageSource {
 public:
  FolderSource(std::string folder, bool loop)
      : folder_(std::move(folder)), loop_(loop), paths_(images_in(folder_)) {
    if (paths_.empty())
      throw FileError(folder_, "contains no image (png, jpg, jpeg, bmp, tif, tiff, pgm, ppm)");
  }

  bool grab() override {
    if (next_ == paths_.size() && loop_) {
      paths_ = images_in(folder_);
      next_ = 0;
    }
    if (next_ == paths_.size()) return false;
    current_ = paths_[next_++];
    return true;
  }

  cv::Mat retrieve() override {
    const cv::Mat image = cv::imread(current_, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    if (image.empty()) throw FileError(current_, "not a readable image; skipped");
    const std::string damage = jpeg_damage(content_of(current_));
    if (!damage.empty()) throw FileError(current_, "damaged (" + damage + "); skipped");
    return image;
  }

  bool is_live() const override { return false; }
  double rate() const override { return 0; }

 private:
  std::string folder_;
  bool loop_;
  std::vector<std::string> paths_;
  std::size_t next_ = 0;
  std::string current_;
};

/// A device, stream or video file.
class CaptureSource : public ImageSource {
 public:
  CaptureSource(const CameraConfig& config, bool is_video)
      : source_(config.source),
        name_(without_secrets(config.source)),
        is_video_(is_video),
        loop_(config.loop && is_video) {
    open();
  }

  /// Sets a property of a device; adds a message to `refused` if the device does not accept it.
  void set_property(int property, const char* key, double value,
                    std::vector<std::string>& refused) {
    if (!capture_.set(property, value))
      refused.push_back(name_ + ": the device does not accept parameter '" + key +
                        "'; the device keeps its own setting");
  }

  bool grab() override {
    if (capture_.grab()) return true;
    if (!is_video_) throw FileError(name_, "delivers no more images");
    if (!loop_) return false;
    open();
    if (!capture_.grab()) throw FileError(name_, "contains no readable image");
    return true;
  }

  cv::Mat retrieve() override {
    cv::Mat image;
    // A new buffer each time, because the previous one may still be in transit to subscribers.
    if (!capture_.retrieve(image) || image.empty())
      throw FileError(name_, "an image could not be decoded; skipped");
    if (image.type() != CV_8UC3 && image.type() != CV_8UC1)
      throw FileError(name_, "delivers images that are not 8-bit with 1 or 3 channels");
    return image;
  }

  bool is_live() const override { return !is_video_; }
  double rate() const override { return std::max(0.0, capture_.get(cv::CAP_PROP_FPS)); }

 private:
  void open() {
    if (!try_open())
      throw FileError(name_, is_video_ ? "not a readable video"
                                       : "the camera does not answer; " + devices_here());
    capture_.set(cv::CAP_PROP_BUFFERSIZE, 1);
  }

  bool try_open() {
    if (is_index(source_)) return capture_.open(std::stoi(source_));
    if (!is_stream(source_)) return capture_.open(source_);
    const QuietOpenCv quiet;
    return capture_.open(source_);
  }

  std::string source_;
  std::string name_;  // name of the source in messages
  bool is_video_;
  bool loop_;
  cv::VideoCapture capture_;
};

void apply_settings(const CameraConfig& config, CaptureSource& device,
                    std::vector<std::string>& refused) {
  constexpr double kManualExposure = 1;  // V4L2's value, passed on by OpenCV
  if (config.width > 0)
    device.set_property(cv::CAP_PROP_FRAME_WIDTH, "width", config.width, refused);
  if (config.height > 0)
    device.set_property(cv::CAP_PROP_FRAME_HEIGHT, "height", config.height, refused);
  if (config.frame_rate > 0)
    device.set_property(cv::CAP_PROP_FPS, "frame_rate", config.frame_rate, refused);
  if (config.exposure >= 0) {
    device.set_property(cv::CAP_PROP_AUTO_EXPOSURE, "exposure", kManualExposure, refused);
    device.set_property(cv::CAP_PROP_EXPOSURE, "exposure", config.exposure, refused);
  }
  if (config.gain >= 0) device.set_property(cv::CAP_PROP_GAIN, "gain", config.gain, refused);
  if (config.white_balance >= 0) {
    device.set_property(cv::CAP_PROP_AUTO_WB, "white_balance", 0, refused);
    device.set_property(cv::CAP_PROP_WB_TEMPERATURE, "white_balance", config.white_balance,
                        refused);
  }
}

}  // namespace

std::string without_secrets(const std::string& source) {
  const auto space = source.find_first_of(" \t\n");
  const bool is_pipeline = source.find(" ! ") != std::string::npos;
  if (space != std::string::npos && (is_stream(source) || is_pipeline)) {
    const std::string word = source.substr(0, space);
    return word.substr(0, word.find("://")) + " ...";
  }
  // This also handles a URL with a mistyped scheme.
  const auto slashes = source.find("://"), colon = source.find(':');
  if (colon == std::string::npos) return source;
  const auto begin = slashes == std::string::npos ? colon + 1 : slashes + 3;
  // Passwords may contain any of / ? # : @, so everything before the last @ is removed.
  const auto at = source.rfind('@');
  const auto host = at == std::string::npos || at < begin ? begin : at + 1;
  const auto query = source.find_first_of("?#", host);
  return source.substr(0, begin) + source.substr(host, query - host) +
         (query == std::string::npos ? "" : "?...");
}

std::unique_ptr<ImageSource> open_image_source(const CameraConfig& config,
                                               std::vector<std::string>& refused) {
  const std::string& source = config.source;
  std::error_code error;
  const fs::file_status status = fs::status(source, error);
  if (fs::is_directory(status)) return std::make_unique<FolderSource>(source, config.loop);
  if (fs::is_regular_file(status)) return std::make_unique<CaptureSource>(config, true);
  if (!is_index(source) && !is_stream(source) && !fs::is_character_file(status))
    throw FileError(without_secrets(source),
                    "no such folder, video, device or stream; " + devices_here());
  auto device = std::make_unique<CaptureSource>(config, false);
  apply_settings(config, *device, refused);
  return device;
}

}  // namespace mbncc::nodelets
