// SPDX-License-Identifier: BSD-3-Clause
// Reads a nodelet's private parameters strictly into a config struct: every key must be known, of
// the right type and in range. Writes single parameters.
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <set>
#include <string>
#include <vector>

#include "mbncc/config/field.hpp"

namespace mbncc::nodelets {

/// Assigns each member of the struct `values` to the row of its name. Members named in `foreign`
/// are ignored, because libraries read them from the same namespace. An integer is accepted for
/// a double or a string; nothing else is converted. Throws ConfigError that names the key,
/// the value and the allowed values or, for an unknown key, the nearest known one.
void assign_parameters(const std::vector<FieldRow>& rows, const XmlRpc::XmlRpcValue& values,
                       const std::set<std::string>& foreign = {});

/// Reads the parameters of the handle's namespace into the rows; unset ones keep their value.
/// `foreign` extends the list of keys that ROS libraries read there (diagnostic_period ...).
/// Throws ConfigError, which also names the namespace.
void read_parameters(const ros::NodeHandle& handle, const std::vector<FieldRow>& rows,
                     std::set<std::string> foreign = {});

/// Writes the parameter with this resolved name. Unlike ros::param::set(), it does not wait for a
/// master that does not answer: the value is then not stored, which is logged.
void store_parameter(const std::string& name, const XmlRpc::XmlRpcValue& value);

}  // namespace mbncc::nodelets
