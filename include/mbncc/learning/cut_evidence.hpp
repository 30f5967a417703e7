// SPDX-License-Identifier: BSD-3-Clause
// How reliable a cut is.
#pragma once

namespace mbncc {

/// Measures of a cut's reliability.
struct CutEvidence {
  double region_touch = 0;  ///< [0..1] part of the outline that lies on the region's edge
  double cut_off = 0;  ///< [0..1] part of the outline beside an intruder, or beside pixels outside
                       ///< the region that look like the object
  double region_span =
      1;  ///< [0..1] extent of the map's box relative to the region's, in the worse direction
  double change_outside = 0;  ///< [0..1] changed part of the strip around the region
  double change_beside = 0;   ///< [map's area] area of certain change in the region outside the map
  double unconfirmed_hole = 0;  ///< [0..1] area of holes that may belong to the object, relative to
                                ///< the map with these holes filled
  double second_departure = 0;  ///< [0..1] evidence that a second object left, relative to the
                                ///< first's: 1 for a map of several large parts; otherwise only of
                                ///< lessons without a given place
  double edges_after = 0;  ///< [0..1] part of the outline whose edge is much weaker before than
                           ///< after the object left; 0 for one image
  double stability = 1;    ///< [0..1] least IoU with cuts of shifted log-odds; for one image: IoU
                           ///< with another method's map
  double boundary_contrast = 1;  ///< [0..1] strength of the image edges along the outline
  bool shadow_like = false;      ///< a shadow of the platform would look like the object
  bool verified = true;  ///< false: cut from one image, without confirmation by a second one
};

}  // namespace mbncc
