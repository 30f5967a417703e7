// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/named_objects.hpp"

#include <gtest/gtest.h>

namespace mbncc {
namespace {

using Names = std::vector<std::string>;

class NamedObjects : public testing::Test {
 protected:
  NamedObjects() {
    for (const char* name : {"bolt", "nut", "plate"}) {
      auto object = std::make_shared<ObjectModel>();
      object->name = name;
      object->enabled = object->name != "plate";
      library_.objects.push_back(object);
      Match match;
      match.name = name;
      result_.matches.push_back(match);
    }
    result_.searched = result_.limited = {"bolt", "nut"};
    result_.skipped = {"bolt: too small", "nut: too small"};
  }

  LibrarySnapshot library_;
  SearchResult result_;
};

TEST_F(NamedObjects, WithoutNamesEverythingStays) {
  keep_named({}, library_, result_);
  EXPECT_EQ(result_.matches.size(), 3u);
  EXPECT_EQ(result_.searched, (Names{"bolt", "nut"}));
  EXPECT_EQ(result_.limited, (Names{"bolt", "nut"}));
  EXPECT_EQ(result_.skipped, (Names{"bolt: too small", "nut: too small"}));
}

TEST_F(NamedObjects, WhatConcernsOthersIsRemoved) {
  keep_named({"nut"}, library_, result_);
  ASSERT_EQ(result_.matches.size(), 1u);
  EXPECT_EQ(result_.matches.front().name, "nut");
  EXPECT_EQ(result_.searched, Names{"nut"});
  EXPECT_EQ(result_.limited, Names{"nut"});
  EXPECT_EQ(result_.skipped, Names{"nut: too small"});
}

TEST_F(NamedObjects, UnknownAndDisabledOnesAreSkippedOnce) {
  keep_named({"screw", "plate", "screw"}, library_, result_);
  EXPECT_EQ(result_.skipped, (Names{"plate: disabled", "screw: unknown"}));
}

}  // namespace
}  // namespace mbncc
