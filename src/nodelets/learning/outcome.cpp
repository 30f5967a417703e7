// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {

mbncc_vision::LearnObjectResult outcome(const Refusal& refusal) {
  mbncc_vision::LearnObjectResult result;
  result.error_code = static_cast<std::int16_t>(refusal.error);
  result.message = refusal.message;
  result.hint = refusal.hint;
  return result;
}

mbncc_vision::LearnObjectResult outcome(LearnError error, const std::string& message,
                                        const std::string& hint) {
  return outcome(Refusal(error, message, hint));
}

}  // namespace mbncc::nodelets
