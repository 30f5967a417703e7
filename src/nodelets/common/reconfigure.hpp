// SPDX-License-Identifier: BSD-3-Clause
// Settings changed at run time, by dynamic_reconfigure's protocol: its clients (rqt_reconfigure,
// dynparam) see names, bounds and meanings of the one field list. A value out of bounds is refused
// and the old one kept, where the library's own server would quietly clamp it.
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

/// The rows of these names, in their order.
Rows chosen(const Rows& rows, const std::vector<std::string>& names);

/// What the rows hold now.
dynamic_reconfigure::Config to_config(const Rows& rows);

/// Names, types, bounds and meanings, with the present values as defaults.
dynamic_reconfigure::ConfigDescription describe(const Rows& rows);

/// Assigns every value of `wanted`; returns a sentence for each one that was refused.
std::vector<std::string> assign(const Rows& rows, const dynamic_reconfigure::Config& wanted);

class Reconfigure {
 public:
  /// Calls its argument with the rows that may change, while nobody else reads them.
  using WithRows = std::function<void(const std::function<void(const Rows&)>&)>;

  /// `changed` is called after each request.
  Reconfigure(ros::NodeHandle private_node, WithRows with_rows, std::function<void()> changed);

  /// As a request that changes one value. An unknown or refused one is told in the log.
  void set(const std::string& name, const std::string& text);

 private:
  /// Calls `change` with the rows and tells everybody what holds then.
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
