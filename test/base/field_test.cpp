// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/config/field.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "mbncc/did_you_mean.hpp"
#include "mbncc/error.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

struct Sample {
  bool flag = true;
  int count = 3;
  double ratio = 0.25;
  std::string engine = "fast";

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"flag", Allowed::anything(), "", "a truth"}, self.flag);
    visit(FieldInfo{"count", Allowed::range(1, 10), "px", "a number"}, self.count);
    visit(FieldInfo{"ratio", Allowed::at_least(0), "", "a share"}, self.ratio);
    visit(FieldInfo{"engine", Allowed::one_of({"fast", "polar"}), "", "a choice"}, self.engine);
  }
};

std::string refusal_of(const std::string& key, const std::string& text) {
  Sample sample;
  try {
    assign_field(field_rows(sample), key, text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Field, AssignsEachType) {
  Sample sample;
  const auto rows = field_rows(sample);
  assign_field(rows, "flag", "false");
  assign_field(rows, "count", "10");
  assign_field(rows, "ratio", "1e3");
  assign_field(rows, "engine", "polar");
  EXPECT_FALSE(sample.flag);
  EXPECT_EQ(sample.count, 10);
  EXPECT_EQ(sample.ratio, 1000);
  EXPECT_EQ(sample.engine, "polar");
}

TEST(Field, RefusalNamesKeyValueAndRange) {
  for (const auto& [key, text, wanted] :
       std::vector<std::array<std::string, 3>>{{"flag", "yes", "true or false"},
                                               {"count", "11", "1 .. 10"},
                                               {"count", "2.5", "an integer"},
                                               {"count", "99999999999", "an integer"},
                                               {"count", "", "an integer"},
                                               {"count", "3 px", "an integer"},
                                               {"ratio", "-0.1", ">= 0"},
                                               {"ratio", "nan", "a number"},
                                               {"ratio", "1,5", "a number"},
                                               {"engine", "Fast", "fast | polar"}}) {
    const std::string refusal = refusal_of(key, text);
    EXPECT_NE(refusal.find("'" + key + "'"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("'" + text + "'"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(wanted), std::string::npos) << refusal;
  }
}

TEST(Field, UnknownKeyErrorNamesTheNearestKey) {
  EXPECT_NE(refusal_of("cuont", "1").find("'count'"), std::string::npos);
}

TEST(Field, RefusedValuesChangeNothing) {
  Sample sample;
  EXPECT_THROW(assign_field(field_rows(sample), "count", "0"), ConfigError);
  EXPECT_EQ(sample.count, 3);
}

TEST(Field, TextReadsBackToTheSameNumber) {
  const FieldInfo info{"x", Allowed::anything(), "", ""};
  for (const double value : {0.0, 1.0, -1.0, 0.1, 1.0 / 3, 100.0, 1e15, 1e-9, 1763692114.123456,
                             6.02214076e23, 123456789012345678.0}) {
    double read = -7;
    parse_field(info, field_text(value), read);
    EXPECT_EQ(read, value) << field_text(value);
  }
  EXPECT_EQ(field_text(100.0), "100");
  EXPECT_EQ(field_text(0.1), "0.1");
}

TEST(Field, YamlFilesAreReadStrictly) {
  TemporaryFolder folder;
  const auto load = [&folder](const std::string& text) {
    std::ofstream(folder / "settings.yaml") << text;
    Sample sample;
    load_yaml_file(field_rows(sample), folder / "settings.yaml");
    return sample;
  };
  EXPECT_EQ(load("# comment\ncount: 7\nengine: polar\n").count, 7);
  EXPECT_THROW(load("cuont: 7\n"), ConfigError);
  EXPECT_THROW(load("count: seven\n"), ConfigError);
  EXPECT_THROW(load("count: [7]\n"), ConfigError);
  EXPECT_THROW(load("? [count]\n: 7\n"), ConfigError);
  EXPECT_THROW(load("- count\n"), FileError);
  EXPECT_THROW(load("count: [7\n"), FileError);
  EXPECT_THROW(load_yaml_file({}, folder / "none.yaml"), FileError);
}

TEST(DidYouMean, NamesTheWordWithTheFewestEdits) {
  EXPECT_EQ(did_you_mean("lern", {"find", "learn", "list"}), "; did you mean 'learn'?");
  EXPECT_EQ(did_you_mean("min_scor", {"min_area", "min_score"}), "; did you mean 'min_score'?");
}

TEST(DidYouMean, NamesNothingThatIsFarAway) {
  EXPECT_EQ(did_you_mean("x", {}), "");
  EXPECT_EQ(did_you_mean("frobnicate", {"find", "forget", "learn"}), "");
  EXPECT_EQ(did_you_mean("--colour", {"--config", "--json", "--name"}), "");
}

}  // namespace
}  // namespace mbncc::test
