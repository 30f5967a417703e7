// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_server.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {
namespace {

using Goal = mbncc_vision::LearnObjectGoal;
using Result = mbncc_vision::LearnObjectResult;

// roscpp sends a published message on another thread; an action server that is destroyed at once
// would lose the result.
constexpr std::chrono::milliseconds kResultFlushTime{100};

// Text of the goal's status: all that a client learns if the result is lost.
std::string text_of(const Result& result) {
  return result.hint.empty() ? result.message : result.message + " " + result.hint;
}

}  // namespace

LessonClient::LessonClient(Handle handle, double timeout, double default_timeout)
    : handle_(std::move(handle)),
      goal_(handle_.getGoal()),
      own_timeout_(timeout > 0),
      deadline_(std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                    std::chrono::duration<double>(own_timeout_ ? timeout : default_timeout))) {}

std::optional<LearnError> LessonClient::interruption() const {
  if (cancelled_ || stopped_) return LearnError::kCancelled;
  const auto left = remaining();
  if (left && *left <= 0) return LearnError::kTimeout;
  return {};
}

void LessonClient::wait_for_operator() {
  if (!own_timeout_) deadline_.reset();
}

std::optional<double> LessonClient::remaining() const {
  if (!deadline_) return {};
  return std::chrono::duration<double>(*deadline_ - std::chrono::steady_clock::now()).count();
}

void LessonClient::tell(mbncc_vision::LearnObjectFeedback feedback) {
  progress_ = std::max(progress_, std::clamp(feedback.progress, 0.0f, 1.0f));
  feedback.progress = progress_;
  feedback.remaining = ros::Duration(std::max(0.0, remaining().value_or(0)));
  handle_.publishFeedback(feedback);
}

void LessonActionServer::forget_images() {
  const boost::recursive_mutex::scoped_lock lock(lock_);
  for (auto& tracked : status_list_)
    if (!tracked.handle_destruction_time_.isZero()) tracked.goal_ = without_images_;
}

LessonServer::LessonServer(ros::NodeHandle node, const std::string& name, double default_timeout,
                           Admit admit, Teach teach)
    : default_timeout_(default_timeout),
      admit_(std::move(admit)),
      teach_(std::move(teach)),
      server_(
          std::move(node), name, [this](LessonClient::Handle handle) { on_goal(handle); },
          [this](LessonClient::Handle handle) { on_cancel(handle); }, false),
      worker_([this] { work(); }) {
  server_.start();
}

LessonServer::~LessonServer() {
  end();
}

void LessonServer::end() {
  if (!worker_.joinable()) return;
  bool interrupted = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    interrupted = running_ != nullptr;
    if (running_) running_->stopped_ = true;
    changed_.notify_all();
  }
  worker_.join();
  if (interrupted) std::this_thread::sleep_for(kResultFlushTime);
}

bool LessonServer::busy() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return running_ != nullptr;
}

std::optional<Result> LessonServer::refusal(const Goal& goal) {
  if (busy()) return outcome(LearnError::kBusy);
  try {
    return admit_(goal);
  } catch (const std::exception& error) {
    return outcome(LearnError::kInternal, error.what());
  }
}

bool LessonServer::reserve(const std::shared_ptr<LessonClient>& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (running_ || stopping_) return false;
  running_ = client;
  accepted_ = false;
  return true;
}

void LessonServer::on_goal(LessonClient::Handle handle) {
  server_.forget_images();
  const auto goal = handle.getGoal();
  if (const auto refused = refusal(*goal)) return handle.setRejected(*refused, text_of(*refused));
  const auto client =
      std::make_shared<LessonClient>(handle, goal->timeout.toSec(), default_timeout_);
  if (!reserve(client)) {
    const Result busy = outcome(LearnError::kBusy);
    return handle.setRejected(busy, text_of(busy));
  }
  handle.setAccepted();
  const std::lock_guard<std::mutex> lock(mutex_);
  accepted_ = true;
  changed_.notify_all();
}

void LessonServer::on_cancel(LessonClient::Handle handle) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (running_ && running_->handle_ == handle) running_->cancelled_ = true;
}

void LessonServer::work() {
  for (;;) {
    server_.forget_images();
    std::shared_ptr<LessonClient> client;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return (running_ && accepted_) || (stopping_ && !running_); });
      if (!running_) return;
      client = running_;
    }
    const Result result = teach_safely(*client);
    {
      // Released first, because a client that gets the result may send the next goal at once.
      const std::lock_guard<std::mutex> lock(mutex_);
      running_.reset();
    }
    finish(*client, result);
  }
}

Result LessonServer::teach_safely(LessonClient& client) {
  try {
    const Result result = teach_(client);
    if (!client.stopped_ || result.error_code != Result::CANCELLED) return result;
    return outcome(LearnError::kCancelled, "The learning nodelet is shutting down.");
  } catch (const std::exception& error) {
    return outcome(LearnError::kInternal, error.what());
  }
}

void LessonServer::finish(LessonClient& client, const Result& result) {
  if (result.error_code == Result::SUCCESS) return client.handle_.setSucceeded(result);
  if (client.cancelled_ && result.error_code == Result::CANCELLED)
    return client.handle_.setCanceled(result, text_of(result));
  client.handle_.setAborted(result, text_of(result));
}

}  // namespace mbncc::nodelets
