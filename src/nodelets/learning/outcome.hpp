// SPDX-License-Identifier: BSD-3-Clause
// The result of a lesson for its client.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>

#include <string>

#include "mbncc/learning/lesson_storage.hpp"

namespace mbncc::nodelets {

/// Result with code, message and hint of `error`; texts given here replace the defaults.
mbncc_vision::LearnObjectResult outcome(LearnError error, const std::string& message = "",
                                        const std::string& hint = "");

mbncc_vision::LearnObjectResult outcome(const Refusal& refusal);

}  // namespace mbncc::nodelets
