// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/stage_writer.hpp"

#include "cli/pictures.hpp"

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

StageWriter::StageWriter(std::string folder) : folder_(std::move(folder)) {
  if (!folder_.empty()) make_output_folder(folder_);
}

StageObserver StageWriter::observer() {
  if (folder_.empty()) return {};
  return [this](Stage stage, double, const std::string&, const cv::Mat& picture) {
    if (!picture.empty())
      write_picture(folder_ + "/" + std::to_string(++count_) + "_" + name_of(stage) + ".png",
                    picture);
    return true;
  };
}

}  // namespace mbncc::cli
