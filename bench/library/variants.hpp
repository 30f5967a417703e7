// SPDX-License-Identifier: BSD-3-Clause
// Makes objects from others, for libraries that are larger than a set of cases.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/case_folder.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::bench {

/// The object of a case as it was learned.
std::shared_ptr<const ObjectModel> object_of(const CaseFolder& one);

/// `count` objects, or as many as can be made: first the given ones, then their mirror images with
/// exchanged colour channels and inverted brightness, which occur in no image.
std::vector<std::shared_ptr<const ObjectModel>> library_of(
    const std::vector<std::shared_ptr<const ObjectModel>>& objects, std::size_t count);

/// `image` in light of another colour: red and blue are multiplied by these factors.
cv::Mat tinted(const cv::Mat& image, double red, double blue);

}  // namespace mbncc::bench
