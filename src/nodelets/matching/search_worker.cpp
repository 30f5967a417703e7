// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/search_worker.hpp"

#include <ros/console.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "mbncc/error.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/matching/search_roi.hpp"

namespace mbncc::nodelets {

using mbncc_vision::DetectedObjectArray;

namespace {

/// Message about an image's stamp; `age` [s] is that of the image by this machine's clock.
std::string stamp_fault(StampGate::Verdict verdict, double age) {
  std::string fault = std::string("an image's stamp is ") + to_string(verdict);
  if (verdict == StampGate::Verdict::kLate || verdict == StampGate::Verdict::kAhead) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, ", by %.3g s", std::abs(age));
    fault += seconds;
  }
  return fault +
         "; compare the clocks, check use_sim_time, max_age and max_ahead, and play bags by "
         "replay.launch";
}

}  // namespace

SearchWorker::SearchWorker(const SearchTools& tools)
    : tools_(tools),
      silence_(tools.settings.initial().stale_after),
      mailbox_(tools.settings.initial().queue_size),
      gate_(tools.settings.initial().max_age, tools.settings.initial().max_ahead) {
  worker_ = std::thread([this] { work(); });
}

SearchWorker::~SearchWorker() {
  mailbox_.close();
  worker_.join();
}

void SearchWorker::put(const sensor_msgs::ImageConstPtr& message) {
  const bool overtaken = mailbox_.put(message);
  statistics_.change([overtaken](SearchStatistics& statistics) {
    ++statistics.arrived;
    statistics.overtaken += overtaken ? 1 : 0;
  });
}

void SearchWorker::invalidate_detections() {
  end_generation();
  mailbox_.clear();
  silence_.restart();
  statistics_.change([](SearchStatistics& statistics) {
    statistics.message.clear();
    statistics.unreliable = false;
  });
}

void SearchWorker::end_generation() {
  const std::lock_guard<std::mutex> lock(publishing_);
  ++generation_;
}

void SearchWorker::work() {
  while (const auto message = mailbox_.take()) {
    try {
      search(**message);
    } catch (const std::exception& error) {
      fail(**message, error.what());
    }
    searching_ = false;
  }
}

void SearchWorker::search(const sensor_msgs::Image& message) {
  const unsigned generation = generation_;
  if (std::exchange(pipeline_generation_, generation) != generation) tools_.pipeline.interrupt();
  if (!admit(message.header)) return;
  const Decoded decoded = decode_image(message, tools_.settings.initial().images.white_level);
  if (!decoded) return refuse(decoded.fault);
  const MatchingNodeConfig settings = tools_.settings.get();
  SearchRequest request;
  try {
    request.roi = roi_in(parse_roi(settings.search_roi), decoded.image.size());
  } catch (const ConfigError& error) {
    return refuse(error.what());
  }
  tools_.pipeline.configure(settings);
  const ReceivedImage received{decoded.image, message.header,
                               tools_.camera.camera_info_for(message.header, decoded.image.size())};
  searching_ = true;
  Detections detections = tools_.pipeline.process(received, request);
  searching_ = false;
  if (!publish(detections.array, generation)) return;
  const MatchingNodeConfig now = tools_.settings.get();
  tools_.publisher.publish_images(
      detections.array, decoded.image, [&] { return tools_.matcher.score_map(decoded.image); },
      now.show_score_map);
}

/// Unless the detections have become invalid. Returns whether they were published.
bool SearchWorker::publish(DetectedObjectArray& array, unsigned generation) {
  {
    const std::lock_guard<std::mutex> lock(publishing_);
    if (generation != generation_) return false;
    tools_.publisher.publish(array, tools_.settings.get().publish_tf);
  }
  note_answer(array.header.stamp);
  statistics_.change([&](SearchStatistics& statistics) {
    ++statistics.searched;
    statistics.search_time = array.search_time;
    statistics.latency = array.latency;
    statistics.message = array.message;
    statistics.unreliable = false;
    statistics.last_fault.clear();
  });
  return true;
}

bool SearchWorker::admit(const std_msgs::Header& header) {
  using Verdict = StampGate::Verdict;
  const double now = ros::Time::now().toSec();
  const Verdict verdict = gate_.judge(header.stamp.toSec(), now);
  if (verdict == Verdict::kRestarted) {
    reset_after_clock_jump();
  } else if (verdict != Verdict::kFresh) {
    statistics_.change([&](SearchStatistics& statistics) {
      ++statistics.badly_stamped;
      statistics.last_fault = stamp_fault(verdict, now - header.stamp.toSec());
    });
    return false;
  }
  if (rate_.allows(header.stamp.toSec(), tools_.settings.get().max_rate)) return true;
  silence_.restart();
  return false;
}

void SearchWorker::reset_after_clock_jump() {
  ROS_INFO("the clock has jumped back; the tracker is reset");
  tools_.pipeline.reset();
  tools_.publisher.reset();
  rate_.reset();
}

void SearchWorker::refuse(const std::string& fault) {
  const bool is_new = statistics_.change([&fault](SearchStatistics& statistics) {
    ++statistics.refused;
    return std::exchange(statistics.last_fault, fault) != fault;
  });
  if (is_new) ROS_WARN("image refused: %s", fault.c_str());
}

void SearchWorker::fail(const sensor_msgs::Image& message, const std::string& reason) {
  tools_.pipeline.reset();  // the video search may have processed only a part of the image
  const std::string sentence =
      "the search failed: " + reason + "; if this recurs, report it with the log";
  const bool is_new = statistics_.change([&sentence](SearchStatistics& statistics) {
    ++statistics.failed;
    statistics.unreliable = true;
    return std::exchange(statistics.message, sentence) != sentence;
  });
  if (is_new) ROS_ERROR("%s", sentence.c_str());
  if (pipeline_generation_ != generation_) return;
  tools_.publisher.publish_fault(DetectedObjectArray::SEARCH_FAILED, message.header, sentence);
  note_answer(message.header.stamp);
}

void SearchWorker::note_answer(const ros::Time& stamp) {
  rate_.note(stamp.toSec(), tools_.settings.get().max_rate);
  silence_.restart();
}

void SearchWorker::check_stale(bool expected) {
  if (!expected) return invalidate_detections();
  if (!silence_.due()) return;
  const std::string reason = reason_of_staleness();
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  tools_.publisher.publish_fault(DetectedObjectArray::STALE, header, reason);
  statistics_.change([&reason](SearchStatistics& statistics) {
    statistics.message = reason;
    statistics.unreliable = true;
  });
  // Confirmed objects may have been moved in the meantime, unless a long search is the reason.
  if (!searching_) end_generation();
}

std::string SearchWorker::reason_of_staleness() const {
  if (searching_)
    return "no image was searched within stale_after; search fewer objects, or raise stale_after";
  const std::string fault = statistics_.get().last_fault;
  if (tools_.camera.publishers() > 0 && !fault.empty()) return "no usable image: " + fault;
  const std::string stream = tools_.camera.fault();
  return stream.empty() ? kNoImages : stream;
}

}  // namespace mbncc::nodelets
