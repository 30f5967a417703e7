// SPDX-License-Identifier: BSD-3-Clause
// GOOD, MARGINAL or BAD, with reasons and advice.
#pragma once

#include <optional>

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/cut_evidence.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::quality {

/// Fills in verdict, reasons and advice from the figures of `quality`.
void decide(Quality& quality, bool touches_border, const std::optional<CutEvidence>& evidence,
            const LearningConfig& config, const SearchConfig& search);

}  // namespace mbncc::quality
