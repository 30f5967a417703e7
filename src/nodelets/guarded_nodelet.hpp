// What the nodelets share: a start that may fail with a sentence.
#pragma once

#include <nodelet/nodelet.h>
#include <ros/console.h>

#include <exception>

namespace mbncc::nodelets {

class GuardedNodelet : public nodelet::Nodelet {
 protected:
  /// Reads the parameters and begins to work; throws with a sentence when that cannot be.
  virtual void start() = 0;

  /// Leaves nothing that uses the nodelet's callback queue: the loader takes that away before it
  /// deletes a nodelet which failed to start. Called then, and by the destructor of the nodelet.
  virtual void stop() = 0;

 private:
  void onInit() final {
    try {
      start();
    } catch (const std::exception& error) {
      NODELET_FATAL("%s", error.what());
      stop();
      throw;
    }
  }
};

}  // namespace mbncc::nodelets
