// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/video_search.hpp"

#include <chrono>
#include <stdexcept>

#include "cell/incremental_search/frame_search.hpp"
#include "matching/scene/grey_image.hpp"

namespace mbncc {
namespace {

using Clock = std::chrono::steady_clock;

bool same_request(const SearchRequest& a, const SearchRequest& b) {
  return a.names == b.names && a.roi == b.roi && a.min_score == b.min_score &&
         a.max_instances == b.max_instances && a.among == b.among;
}

bool same_limits(const SearchConfig& a, const SearchConfig& b) {
  return a.min_score == b.min_score && a.max_instances == b.max_instances;
}

}  // namespace

struct VideoSearch::State {
  State(const SearchRequest& request, const SearchConfig& config, cv::Size image_size)
      : memory(request, config), limits(config), size(image_size) {}

  bool serves(const SearchRequest& request, const SearchConfig& config, cv::Size image) const {
    return image == size && same_request(memory.request, request) && same_limits(limits, config);
  }

  incremental_search::SearchMemory memory;
  SearchConfig limits;
  cv::Size size;
};

VideoSearch::VideoSearch(VideoConfig config) : config_(config) {}
VideoSearch::~VideoSearch() = default;
VideoSearch::VideoSearch(VideoSearch&&) noexcept = default;
VideoSearch& VideoSearch::operator=(VideoSearch&&) noexcept = default;

void VideoSearch::reset() {
  state_.reset();
}

SearchResult VideoSearch::find(const Matcher& matcher, double stamp, const cv::Mat& image,
                               const SearchRequest& request) {
  scene::check_searchable(image);
  if (!request.part.empty() || !request.occupied.empty())
    throw std::invalid_argument(
        "a video search searches whole images; part and occupied must be empty");
  if (config_.sweep_time <= 0) return matcher.find(image, request);
  const auto start = Clock::now();
  const bool restarted = !state_ || !state_->serves(request, matcher.config(), image.size());
  if (restarted) state_ = std::make_unique<State>(request, matcher.config(), image.size());
  incremental_search::FrameSearch frame_search(state_->memory, config_, matcher, stamp, image);
  SearchResult result =
      restarted ? frame_search.search_whole_image() : frame_search.search_changes();
  result.search_time = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace mbncc
