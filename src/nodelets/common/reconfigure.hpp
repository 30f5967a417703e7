// SPDX-License-Identifier: BSD-3-Clause
// Changes settings at run time with dynamic_reconfigure's protocol: its clients (rqt_reconfigure,
// dynparam) get names, bounds and meanings from the field list. A value out of bounds is refused
// and the old one kept, whereas the library's own server would clamp it silently.
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

#include "mbncc/config/field.hpp"

namespace mbncc::nodelets {

using Rows = std::vector<FieldRow>;

/// The rows with these names, in the order of `names`.
Rows chosen(const Rows& rows, const std::vector<std::string>& names);

/// The current values of the rows.
dynamic_reconfigure::Config to_config(const Rows& rows);

/// Names, types, bounds and meanings of the rows, with the current values as defaults.
dynamic_reconfigure::ConfigDescription describe(const Rows& rows);

/// Assigns every value of `wanted`; returns a message for each one that was refused.
std::vector<std::string> assign(const Rows& rows, const dynamic_reconfigure::Config& wanted);

class Reconfigure {
 public:
  /// Calls its argument with the rows that may change, under exclusive access.
  using WithRows = std::function<void(const std::function<void(const Rows&)>&)>;

  /// `changed` is called after each request.
  Reconfigure(ros::NodeHandle private_node, WithRows with_rows, std::function<void()> changed);

  /// Acts like a request that changes one value. An unknown or refused value is logged.
  void set(const std::string& name, const std::string& text);

 private:
  /// Calls `change` with the rows and publishes the new values.
  template <class Change>
  dynamic_reconfigure::Config apply(const Change& change);

  bool on_request(dynamic_reconfigure::Reconfigure::Request& request,
                  dynamic_reconfigure::Reconfigure::Response& response);

  ros::NodeHandle node_;
  const WithRows with_rows_;
  const std::function<void()> changed_;
  ros::Publisher descriptions_, updates_;
  ros::ServiceServer server_;
};

}  // namespace mbncc::nodelets
