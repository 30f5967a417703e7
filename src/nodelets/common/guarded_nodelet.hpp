// SPDX-License-Identifier: BSD-3-Clause
// What the nodelets share: a start that may fail with a sentence, and an end that waits for
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

/// Its callbacks come one at a time, on a thread of its own. On the manager's threads a nodelet
/// that is unloaded amid a callback would be deleted later than its callback queue, which its
/// publishers still use.
class GuardedNodelet : public nodelet::Nodelet {
 protected:
  /// Reads the parameters and begins to work; throws with a sentence when that cannot be. No
  /// callback comes before it has returned.
  virtual void start() = 0;

  /// Ends the threads and whatever else calls the nodelet.
  virtual void stop() = 0;

  /// The nodelet's namespace, and its private one; callbacks come through its own queue.
  ros::NodeHandle node() { return with_own_queue(getNodeHandle()); }
  ros::NodeHandle private_node() { return with_own_queue(getPrivateNodeHandle()); }

  /// To be called by the destructor of the nodelet, whose members the callbacks use.
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
