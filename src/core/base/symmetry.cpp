// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/symmetry.hpp"

#include <stdexcept>

namespace mbncc {
namespace {

constexpr int kMost = 12;                     // beyond it, an object is as good as round
constexpr const char* kProposal = "nearly_";  // prefix of the keys of proposals

}  // namespace

bool is_declarable_symmetry(int symmetry) {
  return symmetry >= 0 && symmetry <= kMost;
}

std::string symmetry_text(std::optional<int> symmetry) {
  if (!symmetry) return "auto";
  if (*symmetry == 0) return "round";
  return *symmetry == 1 ? "none" : std::to_string(*symmetry);
}

std::optional<int> parse_symmetry(const std::string& text) {
  if (text == symmetry_text({})) return {};
  for (int symmetry = 0; is_declarable_symmetry(symmetry); ++symmetry)
    if (text == symmetry_text(symmetry)) return symmetry;
  throw std::invalid_argument("the symmetry '" + text +
                              "' is not known; give auto, none, 2 to 12, or round");
}

void declare_symmetry(ObjectModel& model, std::optional<int> symmetry) {
  if (symmetry && !is_declarable_symmetry(*symmetry))
    throw std::invalid_argument("a symmetry of " + std::to_string(*symmetry) +
                                " cannot be declared; give 1 (none), 2 to 12, or 0 (round)");
  model.symmetry = symmetry;
  if (!symmetry) return;
  Quality& quality = model.quality;
  for (std::size_t i = quality.reasons.size(); i-- > 0;) {
    if (quality.reasons[i].rfind(kProposal, 0) != 0) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    quality.reasons.erase(quality.reasons.begin() + at);
    if (i < quality.advice.size()) quality.advice.erase(quality.advice.begin() + at);
  }
}

}  // namespace mbncc
