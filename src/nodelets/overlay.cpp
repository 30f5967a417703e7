#include "nodelets/overlay.hpp"

#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mbncc/drawing.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;

Standing standing_of(std::uint8_t state) {
  if (state == DetectedObject::CONFIRMED) return Standing::kGood;
  return state == DetectedObject::AMBIGUOUS ? Standing::kDoubtful : Standing::kUnsure;
}

Marking marking_of(const DetectedObject& object) {
  char tail[32];
  std::snprintf(tail, sizeof tail, " #%u %.2f", object.instance_id, object.score);
  Marking marking;
  auto& outline = marking.outlines.emplace_back();
  for (const auto& point : object.outline.points) outline.emplace_back(point.x, point.y);
  marking.pose = {object.image_pose.x, object.image_pose.y, object.image_pose.theta};
  marking.colour = colour_of(standing_of(object.state));
  marking.caption = object.name + tail;
  return marking;
}

}  // namespace

cv::Mat draw_detections(const cv::Mat& picture,
                        const mbncc_vision::DetectedObjectArray& detections) {
  std::vector<Marking> markings;
  for (const auto& object : detections.objects) markings.push_back(marking_of(object));
  return draw_markings(picture, markings);
}

cv::Mat colour_score_map(const cv::Mat& scores) {
  cv::Mat levels, coloured;
  scores.convertTo(levels, CV_8UC1, 255);
  cv::applyColorMap(levels, coloured, cv::COLORMAP_JET);
  return coloured;
}

}  // namespace mbncc::nodelets
