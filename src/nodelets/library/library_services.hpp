// SPDX-License-Identifier: BSD-3-Clause
// The services list_objects, edit_object and reload_library, and the latched topic object_library.
#pragma once

#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/ListObjects.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <memory>

#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// Publishes snapshots of the library on a latched topic, without thumbnails.
class LibraryPublisher {
 public:
  explicit LibraryPublisher(ros::NodeHandle node);
  void publish(const std::string& folder, const LibrarySnapshot& snapshot);

 private:
  ros::Publisher publisher_;
};

class LibraryServices {
 public:
  LibraryServices(ros::NodeHandle node, std::shared_ptr<SharedLibrary> library);

 private:
  bool list(mbncc_vision::ListObjects::Request& request,
            mbncc_vision::ListObjects::Response& response);
  bool edit(mbncc_vision::EditObject::Request& request,
            mbncc_vision::EditObject::Response& response);
  bool reload(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  std::shared_ptr<SharedLibrary> library_;
  ros::ServiceServer list_server_, edit_server_, reload_server_;
};

}  // namespace mbncc::nodelets
