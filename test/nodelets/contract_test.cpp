// Consoles, controllers and bags of other machines are built against these definitions: a changed
// checksum shuts them all out, so it is no side effect of an edit but a decision.
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

TEST(Contract, DefinitionsAreThoseThatOthersWereBuiltAgainst) {
  EXPECT_EQ(checksum<mbncc_vision::DetectedObjectArray>(), "e344a2d95b790e15e32ec14034e7eed9");
  EXPECT_EQ(checksum<mbncc_vision::LearnedObjectArray>(), "84304028cd17b6618c87a3952e320d7f");
  EXPECT_EQ(checksum<mbncc_vision::LearnObjectAction>(), "6fa53828c6120280b4e095e82e699f18");
  EXPECT_EQ(service_checksum<mbncc_vision::ConfirmLearning>(), "70d0faf45158c03a25f54bd7d866c64d");
  EXPECT_EQ(service_checksum<mbncc_vision::EditObject>(), "9f51f22819e2d886290b740983333a41");
  EXPECT_EQ(service_checksum<mbncc_vision::FindObjects>(), "3fcff887786f2a119c3f972e944b7ce5");
  EXPECT_EQ(service_checksum<mbncc_vision::ListObjects>(), "00fe1dca5e2d23f4f4ac4399eae53cf0");
}

}  // namespace
}  // namespace mbncc::nodelets
