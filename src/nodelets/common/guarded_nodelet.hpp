// SPDX-License-Identifier: BSD-3-Clause
// Base class of the nodelets. Its start may fail with a message, and its end waits for running
// callbacks.
#pragma once

#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/spinner.h>

#include <exception>
#include <memory>

#include "nodelets/common/master_watch.hpp"

namespace mbncc::nodelets {

/// Runs its callbacks one at a time on its own spinner thread. On the manager's threads, a nodelet
/// that is unloaded during a callback would be destroyed after its callback queue, which its
/// publishers still use.
class GuardedNodelet : public nodelet::Nodelet {
 protected:
  /// Reads the parameters and starts the work; throws with a message if this fails. No callback
  /// runs before it has returned.
  virtual void start() = 0;

  /// Ends the threads and everything else that calls the nodelet.
  virtual void stop() = 0;

  /// The nodelet's public and private node handles; callbacks use its own queue.
  ros::NodeHandle node() { return with_own_queue(getNodeHandle()); }
  ros::NodeHandle private_node() { return with_own_queue(getPrivateNodeHandle()); }

  /// Ends the callbacks, then calls stop(). Call this in the destructor of the derived class,
  /// because callbacks use its members.
  void finish() {
    spinner_.stop();
    stop();
  }

 private:
  void onInit() final {
    try {
      start();
      spinner_.start();
    } catch (const std::exception& error) {
      NODELET_FATAL("%s: %s", getName().c_str(), error.what());
      finish();
      throw;
    }
  }

  ros::NodeHandle with_own_queue(ros::NodeHandle handle) {
    handle.setCallbackQueue(&queue_);
    return handle;
  }

  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  const std::shared_ptr<MasterWatch> master_watch_ = MasterWatch::shared();
};

}  // namespace mbncc::nodelets
