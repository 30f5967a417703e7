// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/library/library_services.hpp"

#include <mbncc_vision/LearnedObjectArray.h>

#include <stdexcept>
#include <utility>

#include "nodelets/conversion/messages.hpp"
#include "nodelets/library/edit_command.hpp"

namespace mbncc::nodelets {

LibraryPublisher::LibraryPublisher(ros::NodeHandle node)
    : publisher_(node.advertise<mbncc_vision::LearnedObjectArray>("object_library", 1, true)) {}

void LibraryPublisher::publish(const std::string& folder, const LibrarySnapshot& snapshot) {
  mbncc_vision::LearnedObjectArray message;
  message.header.stamp = ros::Time::now();
  message.library_path = folder;
  for (const auto& object : snapshot.objects) message.objects.push_back(to_msg(*object, false));
  publisher_.publish(message);
}

LibraryServices::LibraryServices(ros::NodeHandle node, std::shared_ptr<SharedLibrary> library)
    : library_(std::move(library)),
      list_server_(node.advertiseService("list_objects", &LibraryServices::list, this)),
      edit_server_(node.advertiseService("edit_object", &LibraryServices::edit, this)),
      reload_server_(node.advertiseService("reload_library", &LibraryServices::reload, this)) {}

bool LibraryServices::list(mbncc_vision::ListObjects::Request& request,
                           mbncc_vision::ListObjects::Response& response) {
  response.library_path = library_->folder();
  response.library_inode = folder_inode(response.library_path);
  for (const auto& object : library_->snapshot()->objects)
    response.objects.push_back(to_msg(*object, request.with_thumbnails));
  return true;
}

bool LibraryServices::edit(mbncc_vision::EditObject::Request& request,
                           mbncc_vision::EditObject::Response& response) {
  try {
    const ObjectModel edited = library_->change(
        [&request](ObjectLibrary& library) { return edit_object(library, request); });
    response.object = to_msg(edited, true);
    response.success = true;
    response.message = "done";
  } catch (const std::invalid_argument& refusal) {
    response.message = refusal.what();
  } catch (const std::exception& failure) {
    response.message = failure.what();
    response.retry = true;
  }
  return true;
}

bool LibraryServices::reload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  try {
    library_->refresh(true);
    const auto snapshot = library_->snapshot();
    response.success = true;
    response.message = std::to_string(snapshot->objects.size()) + " objects loaded, " +
                       std::to_string(snapshot->quarantined.size()) + " files quarantined";
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

}  // namespace mbncc::nodelets
