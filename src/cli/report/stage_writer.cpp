// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/stage_writer.hpp"

#include <iostream>

#include "cli/images.hpp"

namespace mbncc::cli {
namespace {

const char* name_of(Stage stage) {
  switch (stage) {
    case Stage::kRegion:
      return "region";
    case Stage::kSegment:
      return "segment";
    case Stage::kQuality:
      return "quality";
  }
  return "stage";
}

}  // namespace

StageWriter::StageWriter(std::string folder, std::vector<std::string> inputs)
    : folder_(std::move(folder)), inputs_(std::move(inputs)) {
  if (!folder_.empty()) make_output_folder(folder_);
}

StageObserver StageWriter::observer(Progress& progress) {
  if (folder_.empty() && !progress.on_terminal()) return {};
  return [&](Stage stage, double part, const std::string& message, const cv::Mat& image) {
    progress.show(part, message);
    if (!folder_.empty() && !image.empty())
      write_image(folder_ + "/" + std::to_string(++count_) + "_" + name_of(stage) + ".png", image,
                  inputs_);
    return true;
  };
}

void StageWriter::tell() const {
  if (count_ > 0)
    std::cerr << "mbncc: wrote " << count_ << " images of the steps to " << folder_ << '\n';
}

}  // namespace mbncc::cli
