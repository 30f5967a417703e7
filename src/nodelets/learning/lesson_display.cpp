// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_display.hpp"

#include <sensor_msgs/Image.h>

#include <memory>

#include "mbncc/matching/matcher.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/matching/overlay.hpp"

namespace mbncc::nodelets {

LessonDisplay::LessonDisplay(ros::NodeHandle& node, const std::string& action)
    : preview_(node.advertise<sensor_msgs::Image>(action + "/preview", 1, true)),
      image_(node.advertise<sensor_msgs::Image>(action + "/picture", 1, true)),
      draft_(node.advertise<mbncc_vision::LearnObjectResult>(action + "/draft", 1, true)),
      score_map_(node.advertise<sensor_msgs::Image>(action + "/score_map", 1)),
      stage_(node.advertise<sensor_msgs::Image>(action + "/stage_image", 1)) {}

void LessonDisplay::show_stage(const cv::Mat& image) const {
  stage_.publish(encode_image(image));
}

void LessonDisplay::show_preview(const cv::Mat& image) const {
  preview_.publish(encode_image(image));
}

void LessonDisplay::show_image(const cv::Mat& image) const {
  image_.publish(encode_image(image));
}

void LessonDisplay::show_draft(const mbncc_vision::LearnObjectResult& draft) const {
  draft_.publish(draft);
}

void LessonDisplay::show_score_map(const ObjectModel& model, const cv::Mat& image,
                                   const SearchConfig& search) const {
  if (score_map_.getNumSubscribers() == 0) return;
  Matcher matcher(search);
  matcher.set_objects({std::make_shared<const ObjectModel>(model)});
  const double radius = model.views.back().template_image.cols / 2.0;
  score_map_.publish(encode_image(draw_score_map(matcher.score_map(image), radius)));
}

}  // namespace mbncc::nodelets
