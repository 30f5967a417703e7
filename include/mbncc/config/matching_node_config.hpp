// SPDX-License-Identifier: BSD-3-Clause
// Settings of the matching nodelet: search, tracking and output.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"
#include "mbncc/config/image_config.hpp"
#include "mbncc/config/platform_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/config/video_config.hpp"

namespace mbncc {

struct MatchingNodeConfig {
  SearchConfig search;
  VideoConfig video;
  PlatformConfig platform;
  ImageConfig images;
  std::string library_path = "~/.ros/mbncc_library";  ///< folder of the learned objects
  std::string search_roi;       ///< "x,y,width,height" [px] of reported reference points; "": all
  double max_rate = 0;          ///< [Hz] limit of searched images; 0: every image that arrives
  int queue_size = 1;           ///< images that can wait for the search; 1: only the newest
  int confirm_frames = 3;       ///< images with a graspable detection needed ...
  int confirm_window = 5;       ///< ... among this many last images
  double hold_time = 0;         ///< [s] for which a lost instance is published as HELD; 0: never
  int average_frames = 10;      ///< images over which the pose of a still instance is averaged
  double max_age = 0.5;         ///< [s] older images are dropped, older poses not confirmed
  double max_ahead = 0.1;       ///< [s] images stamped further in the future are dropped
  double stale_after = 1;       ///< [s] without an image before STALE is published
  bool publish_tf = true;       ///< send tf frames of confirmed instances; counts as a subscriber
  bool show_score_map = false;  ///< draw the score map under the overlay
  std::string tf_prefix;        ///< prefix of every child frame
  std::string target_frame;     ///< frame of the published poses; "": the camera's
  std::string object_frame_z = "into";  ///< direction of the z axis of object frames: into or out
  double tf_wait = 0;  ///< [s] for which an image waits for the tf of its stamp; 0: no waiting

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"library_path", Allowed::anything(), "",
                    "folder of the learned objects; ~ is the home folder"},
          self.library_path);
    SearchConfig::fields(self.search, visit);
    VideoConfig::fields(self.video, visit);
    visit(FieldInfo{"search_roi", Allowed::anything(), "px",
                    "x,y,width,height that must contain the reference points of what is reported "
                    "(the whole image is searched); empty: everywhere"},
          self.search_roi);
    visit(FieldInfo{"max_rate", Allowed::range(0, 1000), "Hz",
                    "limit of searched images per second; 0: every image that arrives"},
          self.max_rate);
    visit(FieldInfo{"queue_size", Allowed::range(1, 100), "",
                    "images that may wait for the search; 1: only the newest, for the freshest "
                    "poses; more: images that come in a burst are all searched"},
          self.queue_size);
    visit(FieldInfo{"confirm_frames", Allowed::range(1, 100), "",
                    "an instance is confirmed if it is graspable in this many images"},
          self.confirm_frames);
    visit(FieldInfo{"confirm_window", Allowed::range(1, 100), "",
                    "number of most recent images in which confirm_frames are counted"},
          self.confirm_window);
    visit(FieldInfo{"hold_time", Allowed::range(0, 60), "s",
                    "a lost instance is published as HELD for this long; 0: never"},
          self.hold_time);
    visit(FieldInfo{"average_frames", Allowed::range(1, 100), "",
                    "the pose of a still instance is averaged over at most this many images"},
          self.average_frames);
    visit(FieldInfo{"max_age", Allowed::range(0.01, 3600), "s",
                    "images older than this are dropped, and older poses are not confirmed"},
          self.max_age);
    visit(FieldInfo{"max_ahead", Allowed::range(0, 3600), "s",
                    "images stamped further in the future are dropped"},
          self.max_ahead);
    visit(FieldInfo{"stale_after", Allowed::range(0.1, 3600), "s",
                    "time without an image after which STALE is published"},
          self.stale_after);
    visit(FieldInfo{"publish_tf", Allowed::anything(), "",
                    "send a tf frame for every confirmed instance; counts as a subscriber"},
          self.publish_tf);
    visit(
        FieldInfo{"show_score_map", Allowed::anything(), "",
                  "draw the coarse search's similarities under the overlay; takes another search"},
        self.show_score_map);
    visit(FieldInfo{"tf_prefix", Allowed::frame(), "", "prefix of every object's tf frame"},
          self.tf_prefix);
    visit(FieldInfo{"target_frame", Allowed::frame(), "",
                    "frame of the published poses; empty: the camera's"},
          self.target_frame);
    visit(FieldInfo{"object_frame_z", Allowed::one_of({"into", "out"}), "",
                    "z of object frames points into the platform, as the optical axis does, or out "
                    "of it, as grasp planners expect"},
          self.object_frame_z);
    visit(
        FieldInfo{"tf_wait", Allowed::range(0, 1), "s",
                  "time for which an image waits for a robot's tf that lags behind; 0: no waiting"},
        self.tf_wait);
    PlatformConfig::fields(self.platform, visit);
    ImageConfig::fields(self.images, visit);
  }
};

}  // namespace mbncc
