// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/explain_service.hpp"

#include <ros/time.h>

#include <boost/date_time/posix_time/posix_time.hpp>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "nodelets/conversion/images.hpp"
#include "nodelets/matching/search_roi.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kPatience = 5;        // [s] for the next live image
constexpr std::size_t kExplained = 3;  // number of objects, the likeliest first
constexpr const char* kFolder = ".misses";

/// Adds a line that names the disabled objects, because the object in the image may be one of them.
void add_disabled(SavedMiss& miss) {
  std::string names;
  for (const auto& object : miss.objects)
    if (!object->enabled) names += (names.empty() ? "'" : ", '") + object->name + "'";
  if (!names.empty())
    miss.lines.push_back("Not searched, because disabled: " + names +
                         ". Enable the one that lies here.");
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
  for (const auto& object : tools_.matcher.library()->objects) {
    if (object->views.front().image_size == miss.image.size())
      miss.objects.push_back(object);
    else if (object->enabled)
      miss.lines.push_back("'" + object->name +
                           "' is not searched: it was learned in images of another size. Teach it "
                           "again at this size.");
  }
  const cv::Rect roi = parse_roi(config.search_roi);
  if (!roi.empty() && !cv::Rect2d(roi).contains(miss.place))
    miss.lines.push_back("The place lies outside search_roi, so nothing is reported here.");
  const auto explanations = mbncc::explain(miss);
  if (explanations.empty())
    miss.lines.push_back(
        "The library has no enabled object learned at this image size: teach or enable one.");
  for (const auto& line : lines_of(explanations, kExplained)) miss.lines.push_back(line);
  if (!explanations.empty()) add_disabled(miss);
  for (const auto& line : miss.lines)
    response.message += (response.message.empty() ? "" : "\n") + line;
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
