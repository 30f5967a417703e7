// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/find_service.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <stdexcept>
#include <utility>

#include "mbncc/cell/stamp_gate.hpp"
#include "mbncc/matching/named_objects.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/matching/frame_permission.hpp"
#include "nodelets/matching/search_roi.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObjectArray;
using Request = FindService::Request;

constexpr double kDefaultTimeout = 5;   // [s]
constexpr double kLongestTimeout = 60;  // [s]
constexpr std::uint32_t kMostFrames = 100;
constexpr std::size_t kMostNames = 1000;
constexpr int kMostCalls = 4;  // number of calls at a time

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::invalid_argument(sentence);
}

[[noreturn]] void refuse_future() {
  refuse("the image is stamped in the future; compare the clocks");
}

[[noreturn]] void refuse_busy() {
  refuse("BUSY: other calls of find_objects are running; call again when they are done");
}

SearchRequest search_request(const Request& request, const MatchingNodeConfig& config,
                             cv::Size size) {
  SearchRequest search;
  if (request.names.size() > kMostNames)
    refuse("more than 1000 names; leave names empty to search for all");
  for (const auto& name : request.names)
    if (!is_valid_name(name))
      refuse("invalid object name; give a letter, then letters, digits or underscores");
  const auto roi = from_msg(request.roi, size);
  if (!roi) refuse("roi is not inside the image; give a region inside it, or none");
  search.roi = roi->empty() ? roi_in(parse_roi(config.search_roi), size) : *roi;
  if (request.min_score > 1)
    refuse("min_score is above 1; give 0 .. 1, or 0 for the configured one");
  if (request.min_score > 0) search.min_score = request.min_score;
  if (request.max_instances > 1000)
    refuse("max_instances is above 1000; give fewer, or 0 for the configured number");
  search.max_instances = static_cast<int>(request.max_instances);
  return search;
}

/// What concerns the requested objects. All objects are searched, so that look-alikes compete.
TrackedImage requested(const Request& request, TrackedImage tracked) {
  keep_named(request.names, *tracked.found.library, tracked.found.result);
  erase_others(request.names, tracked.matches,
               [](const TrackedMatch& match) { return match.match.name; });
  return tracked;
}

/// Removes the instance ids. Every call tracks its own instances, whose ids would be confused with
/// those of the stream.
void clear_instance_ids(DetectedObjectArray& array) {
  for (auto& object : array.objects) object.instance_id = 0;
}

double timeout_of(const Request& request) {
  const double timeout = request.timeout.toSec();
  if (timeout < 0 || timeout > kLongestTimeout) refuse("timeout is not in 0 .. 60 s");
  return timeout > 0 ? timeout : kDefaultTimeout;
}

/// Counts a call while it runs.
class CallCounter {
 public:
  explicit CallCounter(std::atomic<int>& calls) : calls_(calls), number_(++calls) {}
  ~CallCounter() { --calls_; }

  bool is_one_too_many() const { return number_ > kMostCalls; }

 private:
  std::atomic<int>& calls_;
  const int number_;
};

ros::NodeHandle with_queue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace

// There is one more thread than calls at a time, so that further calls are refused at once.
FindService::FindService(ros::NodeHandle node, const FindTools& tools)
    : tools_(tools),
      spinner_(kMostCalls + 1, &queue_),
      server_(with_queue(std::move(node), queue_)
                  .advertiseService("find_objects", &FindService::on_call, this)) {
  spinner_.start();
}

void FindService::close() {
  spinner_.stop();
  server_.shutdown();
}

bool FindService::on_call(Request& request, Response& response) {
  const CallCounter call(calls_);
  try {
    if (call.is_one_too_many()) refuse_busy();
    Detections detections = find(request);
    clear_instance_ids(detections.array);
    permit_frames(detections.array, ros::Time::now(), false);
    response.detections = detections.array;
    response.success = true;
    response.message = response.detections.message;
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

Detections FindService::find(const Request& request) {
  // A thread was free, so the call has just arrived.
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(timeout_of(request)));
  if (request.frames > kMostFrames) refuse("frames is above 100; ask for fewer");
  MatchingNodeConfig config = tools_.settings.get();
  config.video.sweep_time = 0;  // a single request, so the image is searched completely
  config.average_frames = static_cast<int>(std::max(1u, request.frames));
  DetectionPipeline pipeline(config, tools_.matcher, tools_.tf);
  return is_given(request.image) ? find_given(request, config, pipeline, deadline)
                                 : find_live(request, config, pipeline, deadline);
}

Detections FindService::find_given(const Request& request, const MatchingNodeConfig& config,
                                   DetectionPipeline& pipeline, Clock::time_point deadline) {
  const Decoded decoded = decode_image(request.image, config.images.white_level);
  if (!decoded) refuse("image: " + decoded.fault);
  const bool has_info = request.camera_info.width != 0;
  const double ahead = (request.image.header.stamp - ros::Time::now()).toSec();
  if (ahead > config.max_ahead) refuse_future();
  const ReceivedImage received{
      decoded.image, request.image.header,
      has_info ? boost::make_shared<sensor_msgs::CameraInfo>(request.camera_info) : nullptr};
  const auto search = search_request(request, config, decoded.image.size());
  const auto tracked = [&] {
    const auto lock = lock_search(deadline);
    return pipeline.track(received, search);
  }();
  return pipeline.describe(received, requested(request, tracked));
}

Detections FindService::find_live(const Request& request, const MatchingNodeConfig& config,
                                  DetectionPipeline& pipeline, Clock::time_point deadline) {
  const Listening listening(tools_.images, tools_.wants_changed);
  ros::Time after = ros::Time::now();
  StampGate gate(config.max_age, config.max_ahead);
  ReceivedImage received;
  TrackedImage tracked;
  for (std::uint32_t i = 0; i < std::max(1u, request.frames); ++i) {
    StampGate::Verdict verdict;
    do {
      received = next_image(after, config.images.white_level, deadline);
      after = received.header.stamp;
      verdict = gate.judge(after.toSec(), ros::Time::now().toSec());
      if (verdict == StampGate::Verdict::kAhead) refuse_future();
    } while (verdict != StampGate::Verdict::kFresh);
    const auto search = search_request(request, config, received.image.size());
    const auto lock = lock_search(deadline);
    tracked = pipeline.track(received, search);
  }
  // Only now, because an idle nodelet has just begun to listen to camera_info.
  received.camera_info = tools_.camera.camera_info_for(received.header, received.image.size());
  return pipeline.describe(received, requested(request, std::move(tracked)));
}

ReceivedImage FindService::next_image(const ros::Time& after, int white_level,
                                      Clock::time_point deadline) const {
  const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
  const auto message = tools_.images.next(after, left);
  if (!message)
    refuse(
        "no image that is newer than the call arrived in time; check the camera, the image topic "
        "and the clocks");
  const Decoded decoded = decode_image(*message, white_level);
  if (!decoded) refuse(decoded.fault);
  return {decoded.image, message->header, nullptr};
}

std::unique_lock<std::timed_mutex> FindService::lock_search(Clock::time_point deadline) {
  std::unique_lock<std::timed_mutex> lock(searching_, deadline);
  if (!lock) refuse_busy();
  return lock;
}

}  // namespace mbncc::nodelets
