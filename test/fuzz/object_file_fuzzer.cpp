// SPDX-License-Identifier: BSD-3-Clause
// Object files: arbitrary bytes, or an arbitrary description in a valid PNG, because randomly
// changed bytes would fail the checksums.
#include <vector>

#include "fuzz/fuzzer.hpp"
#include "library/png_codec.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"

using namespace mbncc;

namespace {

std::vector<std::uint8_t> file_from(fuzz::Pieces& pieces) {
  const bool raw = pieces.byte() == 'r';
  const std::string content = pieces.rest();
  if (raw) return {content.begin(), content.end()};
  const cv::Mat rgba(6, 5, CV_8UC4, cv::Scalar::all(255));
  return library::encode_png(rgba, "mbncc", content.substr(0, library::PngLimits::kMaxText - 1));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Pieces pieces(data, size);
  try {
    const ObjectModel model = decode_object(file_from(pieces), "/library/object.png");
    if (model.revision > 1) fuzz::planted_bug(model.views.size());
    encode_object(model);  // a model that was read can be written
  } catch (const FileError&) {
  } catch (const std::invalid_argument&) {  // text that PNG cannot contain
  }
  return 0;
}
