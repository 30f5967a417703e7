// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/explain_service.hpp"

#include <ros/time.h>

#include <algorithm>
#include <boost/date_time/posix_time/posix_time.hpp>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "nodelets/conversion/images.hpp"
#include "nodelets/matching/search_roi.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kPatience = 5;  // [s] for the next live image
constexpr const char* kFolder = ".misses";

/// Names the disabled objects, because the object in the image may be one of them; "" without any.
std::string disabled_ones(const std::vector<std::shared_ptr<const ObjectModel>>& objects) {
  std::string names;
  for (const auto& object : objects)
    if (!object->enabled) names += (names.empty() ? "'" : ", '") + object->name + "'";
  return names.empty()
             ? ""
             : "Not searched, because disabled: " + names + ". Enable the one that lies here.";
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

ExplainService::ExplainService(ros::NodeHandle private_node, const ExplainTools& tools)
    : tools_(tools), spinner_(1, &queue_) {
  private_node.setCallbackQueue(&queue_);
  server_ = private_node.advertiseService("explain", &ExplainService::on_call, this);
  spinner_.start();
}

bool ExplainService::on_call(Request& request, Response& response) {
  try {
    explain(request, response);
    response.success = true;
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

sensor_msgs::Image ExplainService::live_image() const {
  const Listening listening(tools_.images, tools_.wants_changed);
  const auto image = tools_.images.next(ros::Time(), kPatience);
  if (!image) throw std::runtime_error("no image arrived from the camera; check it, or send one");
  return *image;
}

void ExplainService::explain(const Request& request, Response& response) const {
  const MatchingNodeConfig config = tools_.config();
  const Decoded decoded = decode_image(is_given(request.image) ? request.image : live_image(),
                                       config.images.white_level);
  if (!decoded) throw std::runtime_error(decoded.fault);
  SavedMiss miss;
  miss.image = decoded.image;
  miss.place = {request.place.x, request.place.y};
  miss.names = request.names;
  miss.search = config.search;
  std::vector<std::string> lines;
  for (const auto& object : tools_.matcher.library()->objects) {
    const std::string other_size = other_image_size(*object, miss.image.size());
    const std::string skipped = "'" + object->name + "' is not searched: " + other_size + ".";
    if (other_size.empty())
      miss.objects.push_back(object);
    else if (contains(request.names, object->name))
      throw std::runtime_error(skipped);
    else if (object->enabled)
      lines.push_back(skipped);
  }
  const cv::Rect roi = parse_roi(config.search_roi);
  if (!roi.empty() && !cv::Rect2d(roi).contains(miss.place))
    lines.push_back("The place lies outside search_roi, so nothing is reported here.");
  const auto explanations = mbncc::explain(miss);
  miss.lines = lines_of(explanations, kExplained);  // those that `mbncc replay` compares
  lines.insert(lines.end(), miss.lines.begin(), miss.lines.end());
  lines.push_back(explanations.empty() ? "The library has no enabled object learned at this image "
                                         "size: teach or enable one."
                                       : disabled_ones(miss.objects));
  for (const auto& line : lines)
    if (!line.empty()) response.message += (response.message.empty() ? "" : "\n") + line;
  response.picture = encode_image(draw_explanation(miss.image, miss.place, explanations));
  if (request.save) response.file = save(miss);
}

std::string ExplainService::save(const SavedMiss& miss) const {
  const std::filesystem::path folder = tools_.matcher.folder() + "/" + kFolder;
  std::filesystem::create_directories(folder);
  const std::string file =
      folder / (boost::posix_time::to_iso_string(ros::WallTime::now().toBoost()) + ".miss");
  write_miss(file, miss);
  return file;
}

}  // namespace mbncc::nodelets
