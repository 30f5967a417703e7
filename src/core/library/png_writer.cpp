// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <new>

#include "library/png_codec.hpp"

namespace mbncc::library {
namespace {

struct Sink {
  std::vector<std::uint8_t> bytes;
  std::jmp_buf jump;
  char message[160] = "";
};

[[noreturn]] void on_error(png_structp png, const char* message) {
  auto* sink = static_cast<Sink*>(png_get_error_ptr(png));
  std::snprintf(sink->message, sizeof sink->message, "%s", message);
  std::longjmp(sink->jump, 1);
}

void on_warning(png_structp, const char*) {}

// libpng is C: an exception must not pass through it, so lack of memory is reported as a libpng
// error.
void on_write(png_structp png, png_bytep data, std::size_t length) {
  auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
  bool stored = true;
  try {
    sink->bytes.insert(sink->bytes.end(), data, data + length);
  } catch (const std::bad_alloc&) {
    stored = false;
  }
  if (!stored) png_error(png, "out of memory");
}

void on_flush(png_structp) {}

struct Writer {
  explicit Writer(Sink& sink)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, on_error, on_warning)),
        info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  png_structp png;
  png_infop info;
};

// Called between setjmp and longjmp, so it must not own anything that needs a destructor.
void write_all(png_structp png, png_infop info, const cv::Mat& rgba, png_text* text) {
  png_set_IHDR(png, info, static_cast<png_uint_32>(rgba.cols), static_cast<png_uint_32>(rgba.rows),
               8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_text(png, info, text, 1);
  png_write_info(png, info);
  for (int row = 0; row < rgba.rows; ++row) png_write_row(png, rgba.ptr<png_byte>(row));
  png_write_end(png, nullptr);
}

}  // namespace

std::vector<std::uint8_t> encode_png(const cv::Mat& rgba, const std::string& key,
                                     const std::string& text, SizeLimit size_limit) {
  if (rgba.type() != CV_8UC4 || !size_limit(rgba.size()) || text.size() > PngLimits::kMaxText)
    throw std::invalid_argument("the image is too large to be stored in one file");
  Sink sink;
  Writer writer(sink);
  if (writer.info == nullptr) throw std::bad_alloc();
  std::string key_copy = key, text_copy = text;  // libpng needs them writable
  png_text chunk{};
  chunk.compression = PNG_ITXT_COMPRESSION_NONE;
  chunk.key = key_copy.data();
  chunk.text = text_copy.data();
  chunk.itxt_length = text.size();
  png_set_write_fn(writer.png, &sink, on_write, on_flush);
  if (setjmp(sink.jump) != 0) throw std::runtime_error(sink.message);
  write_all(writer.png, writer.info, rgba, &chunk);
  return std::move(sink.bytes);
}

}  // namespace mbncc::library
