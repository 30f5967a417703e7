// SPDX-License-Identifier: BSD-3-Clause
// Points of an object at a pose, and what is read from an image there.
#pragma once

#include <cstdint>

namespace mbncc::kernels {

/// A point (px, py) of the object lies at (cosine px - sine py + x, sine px + cosine py + y).
struct Placement {
  float cosine, sine;  ///< of the angle, times `scale`
  float x, y;          ///< [px]
  float scale = 1;
};

/// An 8-bit image with interleaved channels.
struct Image8 {
  const std::uint8_t* data;
  int step;  ///< [bytes] of a row
  int columns, rows;
};

/// Points of an object.
struct Points {
  const float *x, *y;
  int count;
};

struct Colours {
  float *blue, *green, *red;  ///< 0 outside the image
  float* inside;              ///< 1 inside, 0 outside the image
};

/// Edge readings near contour points; all 0 where the image ends.
struct NormalReadings {
  float* response;  ///< [-1..1] largest response within one pixel along the normal
  float* seen;      ///< 1 where `response` was read
  // May be null at reach 0:
  float* pull;    ///< [0..1] largest response within reach
  float* moment;  ///< `pull` times the mean distance [px] along the normal of the responses
};

}  // namespace mbncc::kernels
