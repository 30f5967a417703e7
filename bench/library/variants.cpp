// SPDX-License-Identifier: BSD-3-Clause
#include "library/variants.hpp"

#include <array>

namespace mbncc::bench {
namespace {

using Object = std::shared_ptr<const ObjectModel>;

constexpr std::array<std::array<int, 3>, 6> kOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
constexpr std::size_t kVariants = 4 * kOrders.size();

cv::Mat recoloured(const cv::Mat& image, const std::array<int, 3>& order, bool inverted) {
  std::array<cv::Mat, 3> channels, exchanged;
  cv::split(image, channels.data());
  for (std::size_t c = 0; c < channels.size(); ++c)
    exchanged[c] = channels[static_cast<std::size_t>(order[c])];
  cv::Mat result;
  cv::merge(exchanged.data(), exchanged.size(), result);
  if (inverted) cv::subtract(cv::Scalar::all(255), result, result);
  return result;
}

/// Variant 0 is the object itself.
Object variant_of(const ObjectModel& object, std::size_t variant) {
  auto model = std::make_shared<ObjectModel>(object);
  model->name += "_" + std::to_string(variant);
  const bool mirrored = variant / kOrders.size() % 2 != 0;
  const bool inverted = variant / kOrders.size() / 2 != 0;
  for (auto& view : model->views) {
    view.template_image =
        recoloured(view.template_image, kOrders[variant % kOrders.size()], inverted);
    if (!mirrored) continue;
    cv::flip(view.template_image, view.template_image, 1);
    cv::flip(view.map, view.map, 1);
    view.reference.x = 2 * view.origin.x + view.map.cols - 1 - view.reference.x;
  }
  return model;
}

}  // namespace

Object object_of(const CaseFolder& one) {
  auto object = std::make_shared<ObjectModel>();
  object->name = one.name;
  object->views.push_back(crop_view(one.before, one.map, {one.reference.x, one.reference.y, 0}));
  return object;
}

std::vector<Object> library_of(const std::vector<Object>& objects, std::size_t count) {
  std::vector<Object> library;
  for (std::size_t variant = 0; variant < kVariants; ++variant)
    for (const auto& object : objects) {
      if (library.size() == count) return library;
      library.push_back(variant == 0 ? object : variant_of(*object, variant));
    }
  return library;
}

cv::Mat tinted(const cv::Mat& image, double red, double blue) {
  cv::Mat result;
  cv::multiply(image, cv::Scalar(blue, 1, red), result);
  return result;
}

}  // namespace mbncc::bench
