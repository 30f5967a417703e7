// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/parameters.hpp"

#include <ros/console.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {
namespace {

using XmlRpc::XmlRpcValue;

/// Keys that libraries read from a node's private namespace.
const std::set<std::string> kLibraryKeys{"diagnostic_period", "diagnostic_updater_use_fqn",
                                         "use_fqn", "num_worker_threads"};

const char* name_of(XmlRpcValue::Type type) {
  switch (type) {
    case XmlRpcValue::TypeBoolean:
      return "bool";
    case XmlRpcValue::TypeInt:
      return "int";
    case XmlRpcValue::TypeDouble:
      return "double";
    case XmlRpcValue::TypeString:
      return "string";
    case XmlRpcValue::TypeArray:
      return "list";
    case XmlRpcValue::TypeStruct:
      return "namespace";
    default:
      return "unsupported type";
  }
}

/// `value` as text for parse_field(); "" for lists, namespaces and other types.
std::string text_of(XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return field_text(static_cast<bool>(value));
    case XmlRpcValue::TypeInt:
      return field_text(static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return field_text(static_cast<double>(value));
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      return "";
  }
}

/// The values that the row accepts, in words.
std::string wanted(const FieldRow& row) {
  if (row.type == "bool") return "true or false";
  const std::string kind = row.type == "int"      ? "an integer"
                           : row.type == "double" ? "a number"
                                                  : "a string";
  const std::string unit = row.info.unit.empty() ? "" : " [" + row.info.unit + "]";
  const std::string range = row.info.allowed.to_string();
  return range == "any" ? kind + unit : kind + " " + range + unit;
}

bool type_fits(const std::string& wanted, const std::string& given) {
  return wanted == given || (given == "int" && (wanted == "double" || wanted == "string"));
}

void check_type(const std::vector<FieldRow>& rows, const std::string& key,
                const XmlRpcValue& value) {
  const std::string given = name_of(value.getType());
  for (const auto& row : rows) {
    if (row.info.name != key || type_fits(row.type, given)) continue;
    const std::string shown = text_of(value).empty() ? "" : " '" + text_of(value) + "'";
    throw ConfigError("parameter '" + key + "': the " + given + shown + " is not allowed; give " +
                      wanted(row));
  }
}

}  // namespace

void assign_parameters(const std::vector<FieldRow>& rows, const XmlRpcValue& values,
                       const std::set<std::string>& foreign) {
  if (values.getType() != XmlRpcValue::TypeStruct)
    throw ConfigError("expected a namespace of parameters, not a single value");
  // XmlRpcValue has no iterator over a const struct.
  XmlRpcValue members = values;
  for (auto& member : members) {
    if (foreign.count(member.first) > 0) continue;
    check_type(rows, member.first, member.second);
    assign_field(rows, member.first, text_of(member.second));
  }
}

void read_parameters(const ros::NodeHandle& handle, const std::vector<FieldRow>& rows,
                     std::set<std::string> foreign) {
  foreign.insert(kLibraryKeys.begin(), kLibraryKeys.end());
  XmlRpcValue values;
  if (!handle.getParam(handle.getNamespace(), values)) return;
  assign_parameters(rows, values, foreign);
}

void store_parameter(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = name;
  request[2] = value;
  if (!ros::master::execute("setParam", request, response, payload, false))
    ROS_WARN("parameter %s was not stored: the ROS master does not answer", name.c_str());
}

}  // namespace mbncc::nodelets
