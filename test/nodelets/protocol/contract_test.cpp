// SPDX-License-Identifier: BSD-3-Clause
// Consoles, controllers and bags on other machines are built against these definitions. A changed
// checksum excludes all of them, so it must be a deliberate decision.
#include <gtest/gtest.h>
#include <mbncc_vision/ConfirmLearning.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/FindObjects.h>
#include <mbncc_vision/LearnObjectAction.h>
#include <mbncc_vision/LearnedObjectArray.h>
#include <mbncc_vision/ListObjects.h>

#include <string>

namespace mbncc::nodelets {
namespace {

template <class Message>
std::string checksum() {
  return ros::message_traits::MD5Sum<Message>::value();
}

template <class Service>
std::string service_checksum() {
  return ros::service_traits::MD5Sum<Service>::value();
}

TEST(Contract, MessageDefinitionsAreUnchanged) {
  EXPECT_EQ(checksum<mbncc_vision::DetectedObjectArray>(), "96f7743807fe8968a98c8a3f467f7af5");
  EXPECT_EQ(checksum<mbncc_vision::LearnedObjectArray>(), "b9c340d9e02571b2ba3ca68183cbd949");
  EXPECT_EQ(checksum<mbncc_vision::LearnObjectAction>(), "509cfbcd3356de008752fe0eaa45fe9b");
  EXPECT_EQ(service_checksum<mbncc_vision::ConfirmLearning>(), "4350ff3484d41a8e44a913bde7c58e8b");
  EXPECT_EQ(service_checksum<mbncc_vision::EditObject>(), "ce350f081ce29951b0130a62cb94d83b");
  EXPECT_EQ(service_checksum<mbncc_vision::FindObjects>(), "7556b6ed76dd87fb0ffed650ba74fee3");
  EXPECT_EQ(service_checksum<mbncc_vision::ListObjects>(), "4edba71846f75725986facd1b68d8141");
}

}  // namespace
}  // namespace mbncc::nodelets
