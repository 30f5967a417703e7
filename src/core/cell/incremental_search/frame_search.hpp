// SPDX-License-Identifier: BSD-3-Clause
// Searches one image of a video where it is needed.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "cell/incremental_search/region_search.hpp"
#include "cell/incremental_search/search_memory.hpp"
#include "mbncc/config/video_config.hpp"

namespace mbncc::incremental_search {

class FrameSearch {
 public:
  FrameSearch(SearchMemory& memory, const VideoConfig& config, const Matcher& matcher, double stamp,
              const cv::Mat& image);

  /// Searches the whole image for all objects: for the first image, or after a complete change.
  SearchResult search_whole_image();

  SearchResult search_changes();

 private:
  /// Urgency of the search for an object; the most urgent first.
  enum Urgency { kLost, kUnseen, kSeen };

  void drop_removed_objects(const std::vector<std::string>& gone);
  void rebuild_instances();
  SearchResult search(const cv::Rect& region, const std::vector<std::string>& names);
  std::map<std::string, double> best_outside(const cv::Rect& region,
                                             const std::vector<std::string>& names) const;
  std::vector<Footprint> others(const std::vector<std::string>& names) const;
  void compare(const SearchResult& result, const cv::Rect& region);
  void note_swept(const std::string& name, const SearchResult& result);
  void note_settled();
  bool is_settled(const cv::Rect& box) const;
  Instance instance_from(const Match& match) const;
  bool is_in_motion(const cv::Rect& box) const;
  void verify_touched();
  void search_hidden();
  bool find_again(const Instance& one, const std::vector<Instance>& before);
  void sweep();
  void sweep_for(const std::string& name);
  void search_pending(Urgency least);
  void search_uncompared(const std::string& name, const cv::Rect& region);
  Urgency urgency_of(const std::string& name) const;
  void compare_with_open_objects();
  bool renew(std::vector<Instance>::iterator known);
  void search_overdue();
  void search_again();
  Instance* admit(const Match& match, const std::vector<Instance>& before);
  void schedule_new_instance(const Instance& one);
  void schedule_place(const Instance& one);
  cv::Rect touching(const cv::Rect& box, const std::string& name) const;
  cv::Rect everywhere() const;

  SearchMemory& memory_;
  const VideoConfig& config_;
  const Matcher& matcher_;
  const double stamp_;
  RegionSearch search_;
};

}  // namespace mbncc::incremental_search
