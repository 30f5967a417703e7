// SPDX-License-Identifier: BSD-3-Clause
// Objects made of others, for libraries larger than a set of cases.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/case_folder.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::bench {

/// The object of a case as it was learned.
std::shared_ptr<const ObjectModel> object_of(const CaseFolder& one);

/// `count` objects, or as many as can be made: first those given, then their mirror images with
/// colour channels exchanged and brightness turned round, which lie in no image.
std::vector<std::shared_ptr<const ObjectModel>> library_of(
    const std::vector<std::shared_ptr<const ObjectModel>>& objects, std::size_t count);

/// `image` as under light of another colour: red and blue times these factors.
cv::Mat tinted(const cv::Mat& image, double red, double blue);

}  // namespace mbncc::bench
