// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/mixed_pixel_model.hpp"

#include <algorithm>
#include <cmath>

#include "simd/lanes.hpp"

namespace mbncc::refinement {
namespace {

constexpr float kNowhere = -1e6f;     // lies outside of every picture
constexpr float kLeastShare = 0.12f;  // share of the object from which on a point is used
constexpr float kPure = 0.98f;        // ... and from which on no background is visible

/// The learning picture's value at a place, clamped to the picture.
cv::Vec3f colour_near(const cv::Mat& picture, cv::Point at) {
  const int x = std::clamp(at.x, 0, picture.cols - 1), y = std::clamp(at.y, 0, picture.rows - 1);
  return picture.at<cv::Vec3b>(y, x);
}

/// The object's own colour at a pixel of the learning picture.
cv::Vec3f unmixed_colour(const templates::SurfaceTemplate::Source& source, cv::Point pixel,
                         const templates::EdgeMixing& mixture) {
  constexpr float kTold = 0.35f;  // share from which on it can be separated from the background
  if (mixture.share < kTold) return colour_near(source.surface.colour, pixel);
  cv::Vec3f background;
  for (const auto& place : mixture.beyond)
    background += colour_near(source.picture.colour, place) / 2;
  const cv::Vec3f seen = colour_near(source.picture.colour, pixel);
  cv::Vec3f colour = (seen - (1 - mixture.share) * background) / mixture.share;
  for (int c = 0; c < MixedPixelModel::kChannels; ++c)
    colour[c] = std::clamp(colour[c], 0.f, 255.f);
  return colour;
}

/// Vector inwards, longer near the edge: models the shading of a bevel.
cv::Point2f bevel_at(const templates::SurfaceTemplate::Source& source, cv::Point pixel,
                     const templates::EdgeMixing& mixture) {
  constexpr float kDepth = 2.5f;  // [px]
  const bool on_map = cv::Rect({0, 0}, source.map_size).contains(pixel);
  const float depth = on_map ? source.map.depth(pixel) : 0;
  if (depth > 0) return source.map.inward(pixel) * std::exp(-depth / kDepth);
  const cv::Point2f inward = cv::Point2f(pixel) - mixture.beyond[0];
  return inward / std::max(1e-6, cv::norm(inward));
}

}  // namespace

/// A pixel of the learning picture that shows some of the object.
struct MixedPixelModel::Site {
  cv::Point2f at;  // [px] relative to the anchor, as `beyond`
  std::array<cv::Point2f, 2> beyond;
  float share;
  cv::Vec3f colour;
  cv::Point2f bevel;
};

bool MixedPixelModel::is_mixed(const Site& site) {
  return site.share <= kPure;
}

MixedPixelModel::MixedPixelModel(const templates::SurfaceTemplate::Source& source,
                                 cv::Point2d anchor) {
  source.picture.prepare();
  const auto sites = sites_of(source, anchor);
  place(sites);
  lay_out_light(sites);
}

std::vector<MixedPixelModel::Site> MixedPixelModel::sites_of(
    const templates::SurfaceTemplate::Source& source, cv::Point2d anchor) {
  const templates::AlphaMatte matte(source.map, source.level);
  const cv::Point2f origin(anchor);
  std::vector<Site> sites;
  for (int y = -matte.room(); y < source.map_size.height + matte.room(); ++y)
    for (int x = -matte.room(); x < source.map_size.width + matte.room(); ++x) {
      const cv::Point pixel(x, y);
      const templates::EdgeMixing mixture = matte.at(pixel);
      if (mixture.share < kLeastShare) continue;
      sites.push_back({cv::Point2f(pixel) - origin,
                       {mixture.beyond[0] - origin, mixture.beyond[1] - origin},
                       mixture.share,
                       unmixed_colour(source, pixel, mixture),
                       bevel_at(source, pixel, mixture)});
    }
  std::stable_partition(sites.begin(), sites.end(), is_mixed);
  return sites;
}

void MixedPixelModel::place(const std::vector<Site>& sites) {
  size = static_cast<double>(sites.size());
  background.assign(kernels::whole_lanes(sites.size()), 0.f);
  for (auto* places : {&points, &beyond[0], &beyond[1]})
    for (auto& coordinate : *places) coordinate.assign(padded(), kNowhere);
  const auto put = [this](SearchMask& places, std::size_t i, cv::Point2f at) {
    places[0][i] = at.x;
    places[1][i] = at.y;
    reach = std::max(reach, cv::norm(at));
  };
  mixed = kernels::whole_lanes(
      static_cast<std::size_t>(std::count_if(sites.begin(), sites.end(), is_mixed)));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    put(points, i, sites[i].at);
    radius = std::max(radius, cv::norm(sites[i].at));
    if (!is_mixed(sites[i])) continue;
    background[i] = 1 - sites[i].share;
    for (int k = 0; k < 2; ++k) put(beyond[k], i, sites[i].beyond[k]);
  }
}

const std::vector<int>& MixedPixelModel::terms_along(int axis) {
  static const std::array<std::vector<int>, kChannels> terms{{{0, 1, 4, 5, 6, 7}, {0, 2}, {0, 3}}};
  return terms[axis];
}

void MixedPixelModel::lay_out_light(const std::vector<Site>& sites) {
  const float grey = std::sqrt(3.f);  // brightness of a grey level in all channels
  std::vector<float> colours(kChannels * padded(), 0.f);
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (int c = 0; c < kChannels; ++c) colours[c * padded() + i] = sites[i].colour[c];
  turn_to_axes(colours.data(), padded());
  for (int axis = 0; axis < kChannels; ++axis) {
    const auto& terms = terms_along(axis);
    light[axis].assign(terms.size() * padded(), 0.f);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const cv::Point2f across = grey * sites[i].at / radius, bevel = grey * sites[i].bevel;
      const std::array<float, kLight> all{
          colours[axis * padded() + i], 1, 1, 1, across.x, across.y, bevel.x, bevel.y};
      for (std::size_t k = 0; k < terms.size(); ++k)
        light[axis][k * padded() + i] = (1 - background[i]) * all[terms[k]];
    }
  }
}

void MixedPixelModel::turn_to_axes(float* colours, std::size_t count) {
  const float two = std::sqrt(1 / 2.f), three = std::sqrt(1 / 3.f), six = std::sqrt(1 / 6.f);
  float *const blue = colours, *const green = blue + count, *const red = green + count;
  for (std::size_t i = 0; i < count; ++i) {
    const float b = blue[i], g = green[i], r = red[i];
    blue[i] = three * (b + g + r);
    green[i] = two * (r - b);
    red[i] = six * (b + r - 2 * g);
  }
}

}  // namespace mbncc::refinement
