// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/parameters.hpp"

#include <gtest/gtest.h>
#include <ros/init.h>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {
namespace {

struct Sample {
  bool loop = false;
  int count = 3;
  double rate = 10;
  std::string source = "none";
  std::string mode = "slow";

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"loop", Allowed::anything(), "", "again"}, self.loop);
    visit(FieldInfo{"count", Allowed::range(1, 9), "", "how many"}, self.count);
    visit(FieldInfo{"rate", Allowed::range(0, 100), "Hz", "how fast"}, self.rate);
    visit(FieldInfo{"source", Allowed::anything(), "", "where from"}, self.source);
    visit(FieldInfo{"mode", Allowed::one_of({"slow", "fast"}), "", "how"}, self.mode);
  }
};

using XmlRpc::XmlRpcValue;

template <class Value>
XmlRpcValue one(const std::string& key, const Value& value) {
  XmlRpcValue values;
  values[key] = value;
  return values;
}

/// The message with which `values` are refused; "" if they are accepted.
std::string refusal(const XmlRpcValue& values) {
  Sample sample;
  try {
    assign_parameters(field_rows(sample), values, {"known_to_others"});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Parameters, AreAssignedByName) {
  XmlRpcValue values;
  values["loop"] = true;
  values["count"] = 7;
  values["rate"] = 0.1;
  values["source"] = std::string("/dev/video0");
  values["mode"] = std::string("fast");
  Sample sample;
  assign_parameters(field_rows(sample), values);
  EXPECT_TRUE(sample.loop);
  EXPECT_EQ(sample.count, 7);
  EXPECT_EQ(sample.rate, 0.1);
  EXPECT_EQ(sample.source, "/dev/video0");
  EXPECT_EQ(sample.mode, "fast");
}

TEST(Parameters, KeepTheirDefaultsIfNotSet) {
  Sample sample;
  assign_parameters(field_rows(sample), one("loop", true));
  EXPECT_EQ(sample.count, 3);
  EXPECT_EQ(sample.rate, 10);
}

TEST(Parameters, IntegersAreAcceptedAsDoubleAndString) {
  XmlRpcValue values;
  values["rate"] = 5;
  values["source"] = 0;
  Sample sample;
  assign_parameters(field_rows(sample), values);
  EXPECT_EQ(sample.rate, 5);
  EXPECT_EQ(sample.source, "0");
}

TEST(Parameters, UnknownKeyNamesTheNearest) {
  const std::string sentence = refusal(one("raet", 5.0));
  EXPECT_TRUE(has(sentence, "'raet'")) << sentence;
  EXPECT_TRUE(has(sentence, "'rate'")) << sentence;
}

TEST(Parameters, OutOfRangeNamesKeyValueAndRange) {
  const std::string sentence = refusal(one("rate", 101.5));
  EXPECT_TRUE(has(sentence, "'rate'") && has(sentence, "101.5") && has(sentence, "0 .. 100"))
      << sentence;
  EXPECT_TRUE(has(refusal(one("mode", std::string("medium"))), "slow | fast"));
  EXPECT_NE(refusal(one("count", 0)), "");
}

TEST(Parameters, MistypedIsRefused) {
  EXPECT_TRUE(has(refusal(one("rate", std::string("5"))), "give a number 0 .. 100 [Hz]"));
  EXPECT_NE(refusal(one("count", 2.0)), "");
  EXPECT_NE(refusal(one("count", std::string("2"))), "");
  EXPECT_NE(refusal(one("loop", 1)), "");
  EXPECT_NE(refusal(one("loop", std::string("true"))), "");
  EXPECT_NE(refusal(one("source", true)), "");
  EXPECT_NE(refusal(one("source", 1.5)), "");
  EXPECT_NE(refusal(one("rate", std::nan(""))), "");
}

TEST(Parameters, ListsAndNamespacesAreRefused) {
  XmlRpcValue list;
  list[0] = 1.0;
  EXPECT_TRUE(has(refusal(one("rate", list)), "list"));
  EXPECT_NE(refusal(one("source", list)), "");
  EXPECT_TRUE(has(refusal(one("mode", one("a", 1))), "namespace"));
  EXPECT_NE(refusal(XmlRpcValue(3)), "");
}

TEST(Parameters, KeysOfOtherLibrariesAreIgnored) {
  EXPECT_EQ(refusal(one("known_to_others", one("a", 1))), "");
}

TEST(Parameters, StoringDoesNotWaitForAMasterThatDoesNotAnswer) {
  const ros::M_string nobody{{"__master", "http://localhost:1"}};
  ros::init(nobody, "parameters_test", ros::init_options::NoSigintHandler);
  store_parameter("/parameters_test/search_roi", "0,0,10,10");  // returns, and logs a warning
  SUCCEED();
}

}  // namespace
}  // namespace mbncc::nodelets
