// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/confirmation.hpp"

#include <utility>

namespace mbncc::nodelets {
namespace {

// Interval at which a waiting lesson checks for cancellation.
constexpr std::chrono::milliseconds kPollInterval{50};

Confirmation::Response refuse(const char* message) {
  Confirmation::Response response;
  response.success = false;
  response.message = message;
  return response;
}

}  // namespace

Confirmation::Response Confirmation::ask(const Request& request) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!open_) return refuse("no lesson waits for confirmation; teach with confirm set");
  if (!request.goal_id.empty() && request.goal_id != goal_id_)
    return refuse("the lesson that is meant has ended, and another one waits; look at that one");
  if (request_ || response_) return refuse("the lesson is busy with another command; try again");
  request_ = request;
  changed_.notify_all();
  changed_.wait(lock, [this] { return response_ || !open_; });
  request_.reset();
  if (!response_) return refuse("the lesson ended before the command was carried out");
  return *std::exchange(response_, std::nullopt);
}

void Confirmation::open(const std::string& goal_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  goal_id_ = goal_id;
  open_ = true;
}

std::optional<Confirmation::Request> Confirmation::next(const std::function<bool()>& interrupted,
                                                        std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!interrupted() && std::chrono::steady_clock::now() < end)
    if (changed_.wait_for(lock, kPollInterval, [this] { return request_ && !response_; }))
      return request_;
  return {};
}

void Confirmation::answer(const Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (request_) response_ = response;
  changed_.notify_all();
}

void Confirmation::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  open_ = false;
  changed_.notify_all();
}

}  // namespace mbncc::nodelets
