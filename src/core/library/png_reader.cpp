// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <cstdio>
#include <cstring>

#include "library/png_codec.hpp"
#include "mbncc/image_limits.hpp"

namespace mbncc::library {

void PngReader::on_error(png_structp png, const char* message) {
  auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
  std::snprintf(reader->message_, sizeof reader->message_, "%s", message);
  std::longjmp(reader->jump_, 1);
}

void PngReader::on_warning(png_structp, const char*) {}

void PngReader::on_read(png_structp png, png_bytep data, std::size_t length) {
  auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
  if (length > reader->bytes_.size() - reader->position_) png_error(png, "the file is truncated");
  std::memcpy(data, reader->bytes_.data() + reader->position_, length);
  reader->position_ += length;
}

// Runs calls into libpng. An error in them jumps back here, over frames without destructors, and is
// rethrown as an exception.
template <class Calls>
void PngReader::guarded(Calls&& calls) {
  if (setjmp(jump_) != 0) throw PngError(message_);
  calls();
}

PngReader::PngReader(const std::vector<std::uint8_t>& bytes, const std::string& key,
                     SizeLimit size_limit)
    : bytes_(bytes) {
  create();
  try {
    guarded([this] { png_read_info(png_, info_); });
    check_layout(size_limit);
    find_text(key);
  } catch (...) {
    destroy();
    throw;
  }
}

PngReader::~PngReader() {
  destroy();
}

void PngReader::create() {
  png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
  if (png_ != nullptr) info_ = png_create_info_struct(png_);
  if (info_ == nullptr) {
    destroy();
    throw std::bad_alloc();
  }
  png_set_read_fn(png_, this, on_read);
  png_set_user_limits(png_, ImageLimits::kMostSide, PngLimits::kMaxHeight);
  png_set_chunk_malloc_max(png_, 4 * PngLimits::kMaxText);
  png_set_chunk_cache_max(png_, 16);
  png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_benign_errors(png_, 0);
}

void PngReader::destroy() {
  png_destroy_read_struct(&png_, &info_, nullptr);
}

void PngReader::check_layout(SizeLimit size_limit) {
  size_ = cv::Size(static_cast<int>(png_get_image_width(png_, info_)),
                   static_cast<int>(png_get_image_height(png_, info_)));
  if (!size_limit(size_)) throw PngError("the image is too large");
  if (png_get_bit_depth(png_, info_) != 8 ||
      png_get_color_type(png_, info_) != PNG_COLOR_TYPE_RGB_ALPHA ||
      png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE)
    throw PngError("not an 8-bit RGBA image without interlacing");
}

void PngReader::find_text(const std::string& key) {
  png_textp texts = nullptr;
  int count = 0, found = 0;
  png_get_text(png_, info_, &texts, &count);
  for (int i = 0; i < count; ++i) {
    if (key != texts[i].key) continue;
    const std::size_t length = texts[i].itxt_length + texts[i].text_length;
    if (length > PngLimits::kMaxText) throw PngError("its text chunk is too long");
    text_.assign(texts[i].text, length);
    ++found;
  }
  if (found != 1)
    throw PngError("it has no text chunk '" + key + "', so it is not a learned object");
}

void PngReader::read_row(std::uint8_t* row) {
  guarded([this, row] { png_read_row(png_, row, nullptr); });
}

void PngReader::finish() {
  guarded([this] { png_read_end(png_, nullptr); });
  if (position_ != bytes_.size()) throw PngError("there are bytes after the image's end");
}

}  // namespace mbncc::library
