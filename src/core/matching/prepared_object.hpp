// Everything about an object that does not depend on the picture searched.
#pragma once

#include <memory>
#include <vector>

#include "matching/map_shape.hpp"
#include "matching/refine.hpp"
#include "matching/rotated_kernels.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// One view, in the frame of its anchor: the centre of the map's excircle.
struct PreparedView {
  explicit PreparedView(const View& view);

  int top_level() const { return kernels.level; }

  cv::Point2d anchor;          ///< [px] in the view's crop
  Pose2D reference_in_anchor;  ///< [px],[rad] object frame as seen from the anchor
  MapShape shape;
  KernelBank kernels;
  MaskedTemplate points;             ///< all map pixels at full resolution
  std::vector<Refiner> refiners;     ///< per level 0 .. top_level()
  std::vector<cv::Point2f> outline;  ///< [px] largest outline in the object frame
};

struct PreparedObject {
  explicit PreparedObject(std::shared_ptr<const ObjectModel> object);

  int top_level() const;

  std::shared_ptr<const ObjectModel> model;
  std::vector<PreparedView> views;
};

}  // namespace mbncc
