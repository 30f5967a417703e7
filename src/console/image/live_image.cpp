// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/live_image.hpp"

namespace mbncc::console {
namespace {

constexpr double kSearchedFresh = 1;  // [s] without a searched image before plain ones are shown

}  // namespace

bool LiveImage::take(bool searched, bool teaching, double now) {
  if (searched) searched_at_ = now;
  const bool missing = now - searched_at_ > kSearchedFresh;
  const bool shown = searched ? !teaching : teaching || missing;
  if (shown) shown_at_ = now;
  return shown;
}

}  // namespace mbncc::console
