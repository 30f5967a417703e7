// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/reconfigure.hpp"

#include <ros/console.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "mbncc/error.hpp"
#include "nodelets/common/parameters.hpp"

namespace mbncc::nodelets {
namespace {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigDescription;

constexpr const char* kGroup = "Default";

/// Adds a parameter to the list of its type.
template <class Parameter, class Value>
void add(std::vector<Parameter>& list, const std::string& name, Value value) {
  Parameter& parameter = list.emplace_back();
  parameter.name = name;
  parameter.value = value;
}

void add_value(Config& config, const FieldRow& row, const std::string& text) {
  if (row.type == "bool") return add(config.bools, row.info.name, text == "true");
  if (row.type == "int") return add(config.ints, row.info.name, std::stoi(text));
  if (row.type == "double") return add(config.doubles, row.info.name, std::stod(text));
  add(config.strs, row.info.name, text);
}

void add_bound(Config& config, const FieldRow& row, double bound) {
  if (row.type == "bool") return add(config.bools, row.info.name, bound > 0);
  if (row.type == "double") return add(config.doubles, row.info.name, bound);
  if (row.type == "string") return add(config.strs, row.info.name, std::string());
  constexpr double kLow = std::numeric_limits<int>::min(), kHigh = std::numeric_limits<int>::max();
  add(config.ints, row.info.name, static_cast<int>(std::clamp(bound, kLow, kHigh)));
}

/// The name of a type in dynamic_reconfigure.
std::string client_type(const std::string& type) {
  return type == "string" ? "str" : type;
}

void add_group(Config& config) {
  dynamic_reconfigure::GroupState& group = config.groups.emplace_back();
  group.name = kGroup;
  group.state = true;
}

// BoolParameter::value is a number.
std::string text_of(const dynamic_reconfigure::BoolParameter& flag) {
  return field_text(flag.value != 0);
}

template <class Parameter>
std::string text_of(const Parameter& parameter) {
  return field_text(parameter.value);
}

void assign_one(const Rows& rows, const std::string& name, const std::string& text,
                std::vector<std::string>& refusals) {
  try {
    assign_field(rows, name, text);
  } catch (const ConfigError& error) {
    refusals.push_back(error.what());
  }
}

template <class Parameters>
void assign_all(const Rows& rows, const Parameters& parameters,
                std::vector<std::string>& refusals) {
  for (const auto& parameter : parameters)
    assign_one(rows, parameter.name, text_of(parameter), refusals);
}

/// Writes the values to the parameter server, so that its clients, and the nodelet after a restart,
/// get the current ones.
void store(const ros::NodeHandle& node, const Config& config) {
  const auto store_value = [&node](const std::string& name, const XmlRpc::XmlRpcValue& value) {
    store_parameter(node.resolveName(name), value);
  };
  for (const auto& flag : config.bools) store_value(flag.name, static_cast<bool>(flag.value));
  for (const auto& number : config.ints) store_value(number.name, number.value);
  for (const auto& number : config.doubles) store_value(number.name, number.value);
  for (const auto& text : config.strs) store_value(text.name, text.value);
}

}  // namespace

Rows chosen(const Rows& rows, const std::vector<std::string>& names) {
  Rows result;
  for (const auto& name : names)
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(result),
                 [&](const FieldRow& row) { return row.info.name == name; });
  return result;
}

Config to_config(const Rows& rows) {
  Config config;
  for (const auto& row : rows) add_value(config, row, row.value);
  add_group(config);
  return config;
}

ConfigDescription describe(const Rows& rows) {
  ConfigDescription description;
  auto& group = description.groups.emplace_back();
  group.name = kGroup;
  for (const auto& row : rows) {
    auto& parameter = group.parameters.emplace_back();
    parameter.name = row.info.name;
    parameter.type = client_type(row.type);
    parameter.description = row.info.meaning;
    add_bound(description.min, row, row.type == "bool" ? 0 : row.info.allowed.low);
    add_bound(description.max, row, row.type == "bool" ? 1 : row.info.allowed.high);
  }
  description.dflt = to_config(rows);
  add_group(description.min);
  add_group(description.max);
  return description;
}

std::vector<std::string> assign(const Rows& rows, const Config& wanted) {
  std::vector<std::string> refusals;
  assign_all(rows, wanted.bools, refusals);
  assign_all(rows, wanted.ints, refusals);
  assign_all(rows, wanted.doubles, refusals);
  assign_all(rows, wanted.strs, refusals);
  return refusals;
}

Reconfigure::Reconfigure(ros::NodeHandle private_node, WithRows with_rows,
                         std::function<void()> changed)
    : node_(std::move(private_node)),
      with_rows_(std::move(with_rows)),
      changed_(std::move(changed)),
      descriptions_(node_.advertise<ConfigDescription>("parameter_descriptions", 1, true)),
      updates_(node_.advertise<Config>("parameter_updates", 1, true)) {
  with_rows_([this](const Rows& rows) {
    descriptions_.publish(describe(rows));
    updates_.publish(to_config(rows));
  });
  server_ = node_.advertiseService("set_parameters", &Reconfigure::on_request, this);
}

template <class Change>
Config Reconfigure::apply(const Change& change) {
  std::vector<std::string> refusals;
  with_rows_([&](const Rows& rows) { refusals = change(rows); });
  for (const auto& refusal : refusals) ROS_WARN("%s", refusal.c_str());
  Config config;
  with_rows_([&](const Rows& rows) { config = to_config(rows); });
  store(node_, config);
  updates_.publish(config);
  changed_();
  return config;
}

void Reconfigure::set(const std::string& name, const std::string& text) {
  apply([&](const Rows& rows) {
    std::vector<std::string> refusals;
    assign_one(rows, name, text, refusals);
    return refusals;
  });
}

bool Reconfigure::on_request(dynamic_reconfigure::Reconfigure::Request& request,
                             dynamic_reconfigure::Reconfigure::Response& response) {
  response.config = apply([&](const Rows& rows) { return assign(rows, request.config); });
  return true;
}

}  // namespace mbncc::nodelets
