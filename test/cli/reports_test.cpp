// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "cli/report/match_report.hpp"
#include "cli/report/numbers.hpp"

namespace mbncc::cli {
namespace {

TEST(Reports, ZeroHasNoSign) {
  SearchResult result;
  result.matches.emplace_back();
  result.matches[0].pose.theta = -1e-6;
  std::ostringstream out;
  plain_report(out)->add("a.png", {640, 480}, result);
  EXPECT_NE(out.str().find("), 0.00 deg"), std::string::npos) << out.str();
  EXPECT_EQ(unsigned_zero(-0.0051, 2), -0.0051);
}

}  // namespace
}  // namespace mbncc::cli
