// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/reconfigure.hpp"

#include <gtest/gtest.h>

#include "mbncc/config/matching_node_config.hpp"

namespace mbncc::nodelets {
namespace {

class ReconfigureTest : public testing::Test {
 protected:
  Rows rows() {
    return chosen(field_rows(config_), {"min_score", "max_instances", "publish_tf", "tf_prefix"});
  }

  MatchingNodeConfig config_;
};

TEST_F(ReconfigureTest, ListsChangeableParametersWithTheirBounds) {
  const auto description = describe(rows());
  ASSERT_EQ(description.groups.size(), 1u);
  ASSERT_EQ(description.groups[0].parameters.size(), 4u);
  EXPECT_EQ(description.groups[0].parameters[0].name, "min_score");
  EXPECT_EQ(description.groups[0].parameters[0].type, "double");
  EXPECT_FALSE(description.groups[0].parameters[0].description.empty());
  EXPECT_EQ(description.groups[0].parameters[3].type, "str");
  EXPECT_EQ(description.min.doubles.at(0).value, 0);
  EXPECT_EQ(description.max.doubles.at(0).value, 1);
  EXPECT_EQ(description.max.ints.at(0).value, 1000);
  EXPECT_EQ(description.dflt.bools.at(0).value, 1);
  EXPECT_EQ(to_config(rows()).doubles.at(0).value, config_.search.min_score);
}

TEST_F(ReconfigureTest, AssignsAllowedValuesAndRefusesOthers) {
  dynamic_reconfigure::Config wanted = to_config(rows());
  wanted.bools[0].value = 0;
  wanted.doubles[0].value = 0.5;
  wanted.ints[0].value = 0;
  wanted.strs[0].value = "left_";
  const auto refusals = assign(rows(), wanted);
  ASSERT_EQ(refusals.size(), 1u);
  EXPECT_NE(refusals[0].find("max_instances"), std::string::npos) << refusals[0];
  EXPECT_FALSE(config_.publish_tf);
  EXPECT_EQ(config_.search.min_score, 0.5);
  EXPECT_EQ(config_.search.max_instances, SearchConfig().max_instances) << "the old value is kept";
  EXPECT_EQ(config_.tf_prefix, "left_");
}

TEST_F(ReconfigureTest, RefusesFixedParameters) {
  dynamic_reconfigure::Config wanted;
  wanted.strs.emplace_back();
  wanted.strs[0].name = "library_path";
  wanted.strs[0].value = "/elsewhere";
  EXPECT_EQ(assign(rows(), wanted).size(), 1u);
  EXPECT_EQ(config_.library_path, MatchingNodeConfig().library_path);
}

}  // namespace
}  // namespace mbncc::nodelets
