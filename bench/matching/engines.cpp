// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "matching/engine.hpp"
#include "matching/masked_template_engine.hpp"
#include "matching/mbncc_engine.hpp"
#include "matching/polar_engine.hpp"
#include "matching/sift_engine.hpp"

namespace mbncc::bench {
namespace {

using Maker = std::function<std::unique_ptr<Engine>()>;

const std::vector<std::pair<std::string, Maker>>& makers() {
  static const std::vector<std::pair<std::string, Maker>> list = {
      {"ours", [] { return std::make_unique<MbnccEngine>(); }},
      {"mbncc_polar", [] { return std::make_unique<PolarEngine>(PolarRegion::kMap); }},
      {"ppncc_incircle", [] { return std::make_unique<PolarEngine>(PolarRegion::kIncircle); }},
      {"ppncc_excircle", [] { return std::make_unique<PolarEngine>(PolarRegion::kExcircle); }},
      {"masked_template", [] { return std::make_unique<MaskedTemplateEngine>(); }},
      {"sift_ransac", [] { return std::make_unique<SiftEngine>(); }},
  };
  return list;
}

}  // namespace

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  std::transform(makers().begin(), makers().end(), std::back_inserter(names),
                 [](const auto& maker) { return maker.first; });
  return names;
}

std::unique_ptr<Engine> make_engine(const std::string& name) {
  std::string known;
  for (const auto& [engine, make] : makers()) {
    if (engine == name) return make();
    known += (known.empty() ? "" : ", ") + engine;
  }
  throw std::invalid_argument("there is no engine '" + name + "'; there are: " + known);
}

}  // namespace mbncc::bench
