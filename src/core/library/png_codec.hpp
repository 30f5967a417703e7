// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes PNG with one text chunk, in memory, through libpng: strict about sizes,
// checksums and layout. libpng reports errors by longjmp; these classes turn them into exceptions
// without jumping over a destructor.
#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

struct png_struct_def;
struct png_info_def;

namespace mbncc::library {

/// Bytes that are not a PNG of the accepted kind.
class PngError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Limits of object files.
struct PngLimits {
  static constexpr int kMaxWidth = 8192;    ///< [px]
  static constexpr int kMaxHeight = 65500;  ///< [px]
  static constexpr std::int64_t kMaxPixels = 1 << 23;
  static constexpr std::size_t kMaxText = 1 << 16;  ///< [bytes]
  /// Size of incompressible pixels plus the text. [bytes]
  static constexpr std::size_t kMaxBytes = (std::size_t{4} << 23) + (1 << 18);

  static bool hold(cv::Size size) {
    return size.width > 0 && size.height > 0 && size.width <= kMaxWidth &&
           size.height <= kMaxHeight && std::int64_t{size.width} * size.height <= kMaxPixels;
  }
};

/// Whether images of this size are written and read.
using SizeLimit = bool (*)(cv::Size);

/// Encodes `rgba` (CV_8UC4, R first) with the UTF-8 `text` under `key`. Throws
/// std::invalid_argument if a limit is exceeded.
std::vector<std::uint8_t> encode_png(const cv::Mat& rgba, const std::string& key,
                                     const std::string& text,
                                     SizeLimit size_limit = PngLimits::hold);

/// Reads an 8-bit RGBA PNG row by row, so that the caller can check size and text before it
/// allocates the image. Every member throws PngError.
class PngReader {
 public:
  /// Reads everything up to the pixels. `bytes` must outlive the reader.
  PngReader(const std::vector<std::uint8_t>& bytes, const std::string& key,
            SizeLimit size_limit = PngLimits::hold);
  ~PngReader();
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  cv::Size size() const { return size_; }
  const std::string& text() const { return text_; }

  /// Next row: 4 * size().width bytes, R G B A.
  void read_row(std::uint8_t* row);

  /// Call this after the last row: checks everything that follows the pixels.
  void finish();

 private:
  [[noreturn]] static void on_error(png_struct_def* png, const char* message);
  static void on_warning(png_struct_def* png, const char* message);
  static void on_read(png_struct_def* png, std::uint8_t* data, std::size_t length);
  template <class Calls>
  void guarded(Calls&& calls);
  void create();
  void destroy();
  void check_layout(SizeLimit size_limit);
  void find_text(const std::string& key);

  const std::vector<std::uint8_t>& bytes_;
  std::size_t position_ = 0;
  png_struct_def* png_ = nullptr;
  png_info_def* info_ = nullptr;
  std::jmp_buf jump_;
  char message_[160] = "";
  cv::Size size_;
  std::string text_;
};

}  // namespace mbncc::library
