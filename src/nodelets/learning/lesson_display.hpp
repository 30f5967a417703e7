// SPDX-License-Identifier: BSD-3-Clause
// Topics below the action's name on which a running lesson shows what it has learned
// (docs/interfaces.md).
#pragma once

#include <mbncc_vision/LearnObjectResult.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <opencv2/core.hpp>
#include <string>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::nodelets {

class LessonDisplay {
 public:
  /// `action`: the action's resolved name.
  LessonDisplay(ros::NodeHandle& node, const std::string& action);

  void show_stage(const cv::Mat& image) const;  ///< stage of the segmentation
  void show_preview(const cv::Mat& image) const;
  void show_image(const cv::Mat& image) const;  ///< without annotations; before show_draft()
  void show_draft(const mbncc_vision::LearnObjectResult& draft) const;

  /// Publishes the score map of the object in its learning image, if there is a subscriber.
  void show_score_map(const ObjectModel& model, const cv::Mat& image,
                      const SearchConfig& search) const;

 private:
  ros::Publisher preview_, image_, draft_, score_map_, stage_;
};

}  // namespace mbncc::nodelets
