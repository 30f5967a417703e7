#include "nodelets/outcome.hpp"

namespace mbncc::nodelets {

mbncc_vision::LearnObjectResult outcome(LearnError error, const std::string& message,
                                        const std::string& hint) {
  mbncc_vision::LearnObjectResult result;
  result.error_code = static_cast<std::int16_t>(error);
  result.message = message.empty() ? message_of(error) : message;
  result.hint = hint.empty() ? hint_of(error) : hint;
  return result;
}

}  // namespace mbncc::nodelets
