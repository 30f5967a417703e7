#include "cli/pictures.hpp"

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <system_error>
#include <vector>

#include "cli/picture_header.hpp"
#include "mbncc/error.hpp"

namespace mbncc::cli {
namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} << 20;
constexpr std::uint64_t kMaxPixels = 64'000'000;  // as in messages to the nodelets

std::string errno_text(int code) {
  return std::generic_category().message(code);
}

std::vector<std::uint8_t> read_bytes(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw FileError(path, "there is no such file");
  if (std::filesystem::is_directory(status))
    throw FileError(path, "a folder; give the pictures in it");
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
  const std::string reason = "cannot be written: " + errno_text(errno);
  std::error_code ignored;
  if (file != path) std::filesystem::remove(file, ignored);
  throw FileError(path, reason);
}

void check_header(const std::vector<std::uint8_t>& bytes, const std::string& path) {
  const PictureHeader header = read_picture_header(bytes);
  if (std::uint64_t{header.width} * header.height > kMaxPixels)
    throw FileError(path, "the picture has more than 64 million pixels; scale it down");
  if (header.bits > 8)
    throw FileError(path, std::to_string(header.bits) +
                              " bits per channel; convert it to 8 bits, with the scaling that "
                              "suits the camera");
  if (!header.complete) throw FileError(path, "the file is cut short");
}

cv::Mat decode(const std::string& path, int mode) {
  const auto bytes = read_bytes(path);
  cv::Mat picture;
  try {
    check_header(bytes, path);
    picture = cv::imdecode(bytes, mode);
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& error) {
    throw FileError(path, error.what());
  }
  if (picture.empty()) throw FileError(path, "the picture is damaged");
  return picture;
}

}  // namespace

cv::Mat read_picture(const std::string& path) {
  return decode(path, cv::IMREAD_COLOR);
}

cv::Mat read_map(const std::string& path) {
  return decode(path, cv::IMREAD_GRAYSCALE) > 127;
}

void write_picture(const std::string& path, const cv::Mat& picture) {
  namespace fs = std::filesystem;
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", picture, bytes);
  std::error_code error;
  const bool device = fs::exists(path, error) && !fs::is_regular_file(path, error);
  // A file takes its place when it is whole; what was there before stays until then.
  const std::string unfinished = device ? path : path + ".part";
  write_bytes(unfinished, bytes, path);
  if (device) return;
  fs::rename(unfinished, path, error);
  if (!error) return;
  const std::string reason = "cannot be written: " + error.message();
  fs::remove(unfinished, error);
  throw FileError(path, reason);
}

void make_output_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw FileError(folder, "cannot be made a folder: " + error.message());
}

}  // namespace mbncc::cli
