// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/object_name.hpp"

#include <gtest/gtest.h>

namespace mbncc::console {
namespace {

TEST(ObjectName, UsableNamesAreKept) {
  EXPECT_EQ(usable_name("bracket_2").name, "bracket_2");
  EXPECT_EQ(usable_name("bracket_2").complaint, "");
  EXPECT_EQ(usable_name("").name, "");
}

TEST(ObjectName, ASpaceIsReplacedAndExplained) {
  EXPECT_EQ(usable_name("my part").name, "my_part");
  EXPECT_FALSE(usable_name("my part").complaint.empty());
}

TEST(ObjectName, InvalidCharactersAreRemovedAndExplained) {
  for (const char* typed : {"1part", "_part", " part", "p\u00e4rt", "part!"}) {
    const TypedName name = usable_name(typed);
    EXPECT_TRUE(name.name == "part" || name.name == "prt") << typed;
    EXPECT_FALSE(name.complaint.empty()) << typed;
  }
  EXPECT_EQ(usable_name(std::string(80, 'a')).name.size(), 64u);
}

TEST(ObjectName, AFreeNameGetsANumber) {
  EXPECT_EQ(free_name("part", {"part"}), "part_2");
  EXPECT_EQ(free_name("part", {"part", "part_2"}), "part_3");
  EXPECT_EQ(free_name(std::string(64, 'a'), {}).size(), 64u);
}

}  // namespace
}  // namespace mbncc::console
