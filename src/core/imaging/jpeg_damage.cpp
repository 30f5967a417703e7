// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/jpeg_damage.hpp"

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

namespace mbncc {
namespace {

struct Faults {
  jpeg_error_mgr handler;  // first, so that libjpeg's pointer to it is one to this
  std::jmp_buf jump;
  char first[JMSG_LENGTH_MAX];
};

Faults& faults_of(j_common_ptr image) {
  return *reinterpret_cast<Faults*>(image->err);
}

void note(j_common_ptr image) {
  Faults& faults = faults_of(image);
  if (faults.first[0] == '\0') faults.handler.format_message(image, faults.first);
}

[[noreturn]] void on_error(j_common_ptr image) {
  note(image);
  std::longjmp(faults_of(image).jump, 1);
}

// A negative level is that of a warning: the data are corrupt, and what is missing is invented.
void on_message(j_common_ptr image, int level) {
  if (level < 0) note(image);
}

void on_output(j_common_ptr) {}

class Decoder {
 public:
  Decoder() {
    image_.err = jpeg_std_error(&faults_.handler);
    faults_.handler.error_exit = on_error;
    faults_.handler.emit_message = on_message;
    faults_.handler.output_message = on_output;
  }
  ~Decoder() { jpeg_destroy_decompress(&image_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  // An error jumps back here, over frames without destructors.
  std::string fault_in(const std::vector<std::uint8_t>& bytes) {
    if (setjmp(faults_.jump) == 0) read_to_end(bytes);
    return faults_.first;
  }

 private:
  // At an eighth of the size, all data are decoded, but only few pixels are computed.
  void read_to_end(const std::vector<std::uint8_t>& bytes) {
    jpeg_create_decompress(&image_);
    jpeg_mem_src(&image_, bytes.data(), bytes.size());
    jpeg_read_header(&image_, TRUE);
    image_.scale_denom = 8;
    image_.out_color_space = image_.jpeg_color_space;
    jpeg_start_decompress(&image_);
    const JDIMENSION width =
        image_.output_width * static_cast<JDIMENSION>(image_.output_components);
    const JSAMPARRAY row =
        image_.mem->alloc_sarray(reinterpret_cast<j_common_ptr>(&image_), JPOOL_IMAGE, width, 1);
    while (image_.output_scanline < image_.output_height) jpeg_read_scanlines(&image_, row, 1);
    jpeg_finish_decompress(&image_);
  }

  Faults faults_{};
  jpeg_decompress_struct image_{};
};

}  // namespace

std::string jpeg_damage(const std::vector<std::uint8_t>& bytes) {
  const bool is_jpeg = bytes.size() > 2 && bytes[0] == 0xff && bytes[1] == 0xd8;
  return is_jpeg ? Decoder().fault_in(bytes) : "";
}

}  // namespace mbncc
