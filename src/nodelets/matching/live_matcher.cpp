// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/live_matcher.hpp"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace mbncc::nodelets {
namespace {

bool wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

bool same_values(SearchConfig a, SearchConfig b) {
  const auto rows = field_rows(a), others = field_rows(b);
  return std::equal(
      rows.begin(), rows.end(), others.begin(), others.end(),
      [](const FieldRow& row, const FieldRow& other) { return row.value == other.value; });
}

// Removes objects that cannot be searched, or were learned in images of another size, from
// `names`. Returns a message for each of them.
std::vector<std::string> drop_unfit(const LibrarySnapshot& library,
                                    const std::map<std::string, std::string>& unsearchable,
                                    cv::Size size, std::vector<std::string>& names) {
  std::vector<std::string> fitting, dropped;
  for (const auto& name : names)
    if (!library.find(name)) fitting.push_back(name);  // the matcher reports it as unknown
  for (const auto& object : library.objects) {
    if (!wanted(names, object->name) || (names.empty() && !object->enabled)) continue;
    const std::string other_size = other_image_size(*object, size);
    const auto fault = unsearchable.find(object->name);
    if (fault != unsearchable.end())
      dropped.push_back(object->name + ": " + fault->second);
    else if (other_size.empty())
      fitting.push_back(object->name);
    else
      dropped.push_back(object->name + ": " + other_size);
  }
  names = fitting;
  return dropped;
}

}  // namespace

LiveMatcher::LiveMatcher(const SearchConfig& config, const std::string& library_path)
    : matcher_(config), library_(library_path, [this](const SharedLibrary::Snapshot& snapshot) {
        take_over(snapshot);
      }) {}

Found LiveMatcher::find(const cv::Mat& image, SearchRequest request) const {
  const auto lock = reading();
  const std::string unreadable = library_.fault();
  if (!unreadable.empty()) return nothing_found(request.names, unreadable);
  Found found;
  found.library = searched_;
  const auto dropped = drop_unfit(*searched_, matcher_.unsearchable(), image.size(), request.names);
  // An empty list would mean all objects.
  sort_least_recent_first(request.names);
  if (!request.names.empty()) found.result = matcher_.find(image, request);
  note_searched(found.result.searched);
  found.result.skipped.insert(found.result.skipped.end(), dropped.begin(), dropped.end());
  return found;
}

Found LiveMatcher::watch(VideoSearch& video, double stamp, const cv::Mat& image,
                         SearchRequest request) const {
  const auto lock = reading();
  const std::string unreadable = library_.fault();
  if (!unreadable.empty()) return nothing_found(request.names, unreadable);
  Found found;
  found.library = searched_;
  const std::vector<std::string> asked = request.names;
  const auto dropped = drop_unfit(*searched_, matcher_.unsearchable(), image.size(), request.names);
  const bool any = !request.names.empty();
  // A different request would restart the video search, so the request must not change when objects
  // are taught or deleted.
  if (dropped.empty()) request.names = asked;
  if (any) found.result = video.find(matcher_, stamp, image, request);
  found.result.skipped.insert(found.result.skipped.end(), dropped.begin(), dropped.end());
  return found;
}

Found LiveMatcher::nothing_found(const std::vector<std::string>& names,
                                 const std::string& reason) const {
  Found found;
  found.library = searched_;
  for (const auto& object : searched_->objects)
    if (wanted(names, object->name) && object->enabled)
      found.result.skipped.push_back(object->name + ": " + reason);
  return found;
}

void LiveMatcher::sort_least_recent_first(std::vector<std::string>& names) const {
  const std::lock_guard<std::mutex> lock(searches_mutex_);
  const auto last_search = [this](const std::string& name) {
    const auto last = last_search_.find(name);
    return last == last_search_.end() ? 0 : last->second;
  };
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return last_search(a) < last_search(b);
  });
}

void LiveMatcher::note_searched(const std::vector<std::string>& names) const {
  const std::lock_guard<std::mutex> lock(searches_mutex_);
  ++searches_;
  for (const auto& name : names) last_search_[name] = searches_;
}

cv::Mat LiveMatcher::score_map(const cv::Mat& image) const {
  const auto lock = reading();
  return matcher_.score_map(image);
}

bool LiveMatcher::configure(const SearchConfig& config) {
  const auto lock = writing();
  if (same_values(matcher_.config(), config)) return false;
  matcher_.configure(config);
  return true;
}

std::string LiveMatcher::fault() const {
  const std::string unreadable = library_.fault();
  // Not in turn: a long search that a new library waits for must not delay the diagnostics.
  const std::shared_lock<std::shared_mutex> lock(mutex_);
  const auto& unsearchable = matcher_.unsearchable();
  if (!unreadable.empty() || unsearchable.empty()) return unreadable;
  const auto& [name, reason] = *unsearchable.begin();
  const std::size_t more = unsearchable.size() - 1;
  return name + " " + reason + (more > 0 ? "; " + std::to_string(more) + " more" : "");
}

void LiveMatcher::take_over(const SharedLibrary::Snapshot& snapshot) {
  const auto lock = writing();
  matcher_.set_objects(snapshot->objects);
  searched_ = snapshot;
}

std::shared_lock<std::shared_mutex> LiveMatcher::reading() const {
  const std::lock_guard<std::mutex> turn(turn_);
  return std::shared_lock<std::shared_mutex>(mutex_);
}

std::unique_lock<std::shared_mutex> LiveMatcher::writing() {
  const std::lock_guard<std::mutex> turn(turn_);
  return std::unique_lock<std::shared_mutex>(mutex_);
}

}  // namespace mbncc::nodelets
