#include "nodelets/find_service.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "nodelets/images.hpp"
#include "nodelets/messages.hpp"
#include "nodelets/search_roi.hpp"

namespace mbncc::nodelets {
namespace {

using Request = FindService::Request;

constexpr double kDefaultTimeout = 5;   // [s]
constexpr double kLongestTimeout = 60;  // [s]
constexpr std::uint32_t kMostFrames = 100;
constexpr std::size_t kMostNames = 1000;

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::invalid_argument(sentence);
}

SearchRequest search_request(const Request& request, const MatchingNodeConfig& config,
                             cv::Size size) {
  SearchRequest search;
  if (request.names.size() > kMostNames) refuse("more than 1000 names");
  for (const auto& name : request.names)
    if (!is_valid_name(name)) refuse("a name is none of an object");
  search.names = request.names;
  const auto roi = from_msg(request.roi, size);
  if (!roi) refuse("roi does not lie in the picture");
  search.roi = roi->empty() ? parse_roi(config.search_roi) : *roi;
  if (request.min_score > 1) refuse("min_score lies above 1");
  if (request.min_score > 0) search.min_score = request.min_score;
  if (request.max_instances > 1000) refuse("max_instances lies above 1000");
  search.max_instances = static_cast<int>(request.max_instances);
  return search;
}

/// Keeps live pictures coming.
class Listening {
 public:
  explicit Listening(const FindTools& tools) : tools_(tools) {
    tools_.pictures.enter();
    tools_.wants_changed();
  }
  ~Listening() {
    tools_.pictures.leave();
    tools_.wants_changed();
  }

 private:
  const FindTools& tools_;
};

double timeout_of(const Request& request) {
  const double timeout = request.timeout.toSec();
  if (timeout < 0 || timeout > kLongestTimeout) refuse("timeout is not in 0 .. 60 s");
  return timeout > 0 ? timeout : kDefaultTimeout;
}

}  // namespace

FindService::FindService(ros::NodeHandle node, const FindTools& tools)
    : tools_(tools), server_(node.advertiseService("find_objects", &FindService::on_call, this)) {}

bool FindService::on_call(Request& request, Response& response) {
  try {
    response.detections = find(request).array;
    response.success = true;
    response.message = response.detections.message;
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

Detections FindService::find(const Request& request) const {
  MatchingNodeConfig config = tools_.config;
  config.video.sweep_time = 0;  // asked once, everything is looked at
  config.average_frames = static_cast<int>(std::clamp(request.frames, 1u, kMostFrames));
  DetectionPipeline pipeline(config, tools_.matcher, tools_.tf);
  if (!is_given(request.image)) return find_live(request, pipeline);
  const Decoded decoded = decode_picture(request.image);
  if (!decoded) refuse("image: " + decoded.fault);
  const bool has_info = request.camera_info.width != 0;
  const ReceivedPicture received{
      decoded.picture, request.image.header,
      has_info ? boost::make_shared<sensor_msgs::CameraInfo>(request.camera_info) : nullptr};
  return pipeline.process(received, search_request(request, tools_.config, decoded.picture.size()));
}

Detections FindService::find_live(const Request& request, DetectionPipeline& pipeline) const {
  if (request.frames > kMostFrames) refuse("frames lies above 100");
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double timeout = timeout_of(request);
  const Listening listening(tools_);
  ros::Time after = ros::Time::now();
  ReceivedPicture received;
  TrackedPicture tracked;
  for (std::uint32_t i = 0; i < std::max(1u, request.frames); ++i) {
    const double waited = std::chrono::duration<double>(Clock::now() - start).count();
    received = next_picture(after, timeout - waited);
    after = received.header.stamp;
    tracked =
        pipeline.track(received, search_request(request, tools_.config, received.picture.size()));
  }
  return pipeline.describe(received, tracked);
}

ReceivedPicture FindService::next_picture(const ros::Time& after, double timeout) const {
  const auto image = tools_.pictures.next(after, timeout);
  if (!image) refuse("no picture came in time; check the camera and the image topic");
  const Decoded decoded = decode_picture(*image);
  if (!decoded) refuse(decoded.fault);
  return {decoded.picture, image->header, tools_.camera.camera_info_for(*image)};
}

}  // namespace mbncc::nodelets
