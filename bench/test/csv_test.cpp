// SPDX-License-Identifier: BSD-3-Clause
#include "common/csv.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace mbncc::bench {
namespace {

class Csv : public ::testing::Test {
 protected:
  std::vector<CsvRow> rows_of(const std::string& text) {
    std::ofstream(path_) << text;
    return read_csv(path_);
  }
  test::TemporaryFolder folder_;
  std::string path_ = folder_ / "rows.csv";
};

TEST_F(Csv, ReadsRowsByColumnName) {
  const auto rows = rows_of("a,b\n1,2\r\n3,\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("b"), "2");
  EXPECT_EQ(rows[1].at("a"), "3");
  EXPECT_EQ(rows[1].at("b"), "");
}

TEST_F(Csv, RefusesRowsOfAnotherWidthAndMissingFiles) {
  EXPECT_THROW(rows_of("a,b\n1\n"), std::runtime_error);
  EXPECT_THROW(read_csv(path_ + ".missing"), std::runtime_error);
}

TEST(Split, DropsEmptyParts) {
  EXPECT_EQ(split("a;;b", ';'), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(split("", ';').empty());
}

}  // namespace
}  // namespace mbncc::bench
