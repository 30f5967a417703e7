// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/overlay_writer.hpp"

#include <filesystem>
#include <iostream>

#include "cli/images.hpp"
#include "mbncc/matching/overlay.hpp"

namespace mbncc::cli {

OverlayWriter::OverlayWriter(std::string folder, std::vector<std::string> inputs)
    : folder_(std::move(folder)), inputs_(std::move(inputs)) {
  if (!folder_.empty()) make_output_folder(folder_);
}

void OverlayWriter::write(const std::string& image_path, const cv::Mat& image,
                          const std::vector<Match>& matches) {
  if (folder_.empty()) return;
  const std::string stem = folder_ + "/" + std::filesystem::path(image_path).stem().string();
  std::string path = stem + "_overlay.png";
  for (int i = 2; written_.count(path) > 0; ++i)
    path = stem + "_" + std::to_string(i) + "_overlay.png";
  write_image(path, draw_matches(image, matches), inputs_);
  written_.insert(path);
}

void OverlayWriter::tell() const {
  if (!written_.empty())
    std::cerr << "mbncc: wrote " << written_.size() << " annotated images to " << folder_ << '\n';
}

}  // namespace mbncc::cli
