// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/library/edit_command.hpp"

#include <gtest/gtest.h>
#include <mbncc_vision/LearnObjectGoal.h>

#include <cmath>
#include <limits>

#include "library/models.hpp"
#include "nodelets/conversion/messages.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using Request = mbncc_vision::EditObject::Request;

class EditObject : public ::testing::Test {
 protected:
  EditObject() {
    ObjectModel model = test::random_model(1, "cup");
    model.grasp.reset();
    library_.save(model, ObjectLibrary::Existing::kRefuse);
  }

  Request request(std::uint8_t command) {
    Request request;
    request.name = "cup";
    request.command = command;
    return request;
  }

  ObjectModel stored(const std::string& name = "cup") { return *library_.load()->find(name); }

  test::TemporaryFolder folder_;
  ObjectLibrary library_{folder_.path()};
};

TEST_F(EditObject, SwitchesTheSearchOffAndOn) {
  EXPECT_FALSE(edit_object(library_, request(Request::DISABLE)).enabled);
  EXPECT_FALSE(stored().enabled);
  EXPECT_TRUE(edit_object(library_, request(Request::ENABLE)).enabled);
  EXPECT_TRUE(stored().enabled);
}

TEST_F(EditObject, Renames) {
  auto rename = request(Request::RENAME);
  rename.new_name = "mug";
  rename.label = "The mug";
  EXPECT_EQ(edit_object(library_, rename).name, "mug");
  EXPECT_EQ(stored("mug").label, "The mug");
  EXPECT_EQ(library_.load()->find("cup"), nullptr);
}

TEST_F(EditObject, DeletesAndRestores) {
  EXPECT_EQ(edit_object(library_, request(Request::DELETE)).name, "cup");
  EXPECT_TRUE(library_.load()->objects.empty());
  EXPECT_EQ(edit_object(library_, request(Request::RESTORE)).name, "cup");
  EXPECT_NE(library_.load()->find("cup"), nullptr);
}

TEST_F(EditObject, RestoresObjectsOnly) {
  auto restore = request(Request::RESTORE);
  edit_object(library_, request(Request::DELETE));
  restore.name = "cup.1";
  EXPECT_THROW(edit_object(library_, restore), NameError);
  EXPECT_TRUE(library_.load()->objects.empty());
}

TEST_F(EditObject, MovesTheReference) {
  auto move = request(Request::SET_REFERENCE);
  move.reference.x = 5;
  move.reference.theta = 0.5;
  const std::uint32_t before = stored().revision;
  edit_object(library_, move);
  EXPECT_DOUBLE_EQ(stored().views.front().reference.x, 5);
  EXPECT_DOUBLE_EQ(stored().views.front().reference.theta, 0.5);
  EXPECT_GT(stored().revision, before);
}

TEST_F(EditObject, KeepsTheGraspWhenTheReferenceMoves) {
  auto grasp = request(Request::SET_GRASP);
  grasp.grasp.orientation.w = 1;
  edit_object(library_, grasp);
  auto move = request(Request::SET_REFERENCE);
  move.reference.x = stored().views.front().reference.x + 10;
  move.reference.y = stored().views.front().reference.y;
  move.reference.theta = stored().views.front().reference.theta;
  const ObjectModel moved = edit_object(library_, move);
  const auto& place = moved.grasp->position;
  EXPECT_NEAR(std::hypot(place[0], place[1]), 10 * moved.metres_per_pixel, 1e-9);
  grasp.clear = true;
  edit_object(library_, grasp);
  EXPECT_FALSE(stored().grasp);
  EXPECT_NO_THROW(edit_object(library_, request(Request::SET_REFERENCE)));
}

TEST_F(EditObject, SetsAndClearsTheThreshold) {
  auto threshold = request(Request::SET_THRESHOLD);
  threshold.min_score = 0.5f;
  EXPECT_DOUBLE_EQ(*edit_object(library_, threshold).min_score, 0.5);
  threshold.clear = true;
  EXPECT_FALSE(edit_object(library_, threshold).min_score);
}

TEST_F(EditObject, DeclaresTheSymmetry) {
  auto declare = request(Request::SET_SYMMETRY);
  declare.symmetry = mbncc_vision::LearnObjectGoal::SYMMETRY_ROUND;
  const std::uint32_t before = stored().revision;
  EXPECT_EQ(edit_object(library_, declare).symmetry, 0);
  EXPECT_EQ(stored().symmetry, 0);
  EXPECT_GT(stored().revision, before) << "the poses of a round object may turn";
  declare.symmetry = mbncc_vision::LearnObjectGoal::SYMMETRY_2;
  EXPECT_EQ(edit_object(library_, declare).symmetry, 2);
  for (const int wrong : {13, 100, 254}) {
    declare.symmetry = static_cast<std::uint8_t>(wrong);
    EXPECT_THROW(edit_object(library_, declare), std::invalid_argument) << wrong;
  }
  EXPECT_EQ(stored().symmetry, 2);
  declare.symmetry = mbncc_vision::LearnObjectGoal::SYMMETRY_AUTO;
  EXPECT_FALSE(edit_object(library_, declare).symmetry);
}

TEST_F(EditObject, RefusesInvalidRequestsAndChangesNothing) {
  const ObjectModel before = stored();
  auto threshold = request(Request::SET_THRESHOLD);
  for (const float score : {0.0f, -1.0f, 1.5f, std::numeric_limits<float>::quiet_NaN()}) {
    threshold.min_score = score;
    EXPECT_THROW(edit_object(library_, threshold), std::invalid_argument) << score;
  }
  auto reference = request(Request::SET_REFERENCE);
  for (const double y : {std::numeric_limits<double>::infinity(), 1e9, -1e9}) {
    reference.reference.y = y;
    EXPECT_THROW(edit_object(library_, reference), std::invalid_argument) << y;
  }
  EXPECT_THROW(edit_object(library_, request(Request::SET_GRASP)), std::invalid_argument);
  EXPECT_THROW(edit_object(library_, request(99)), std::invalid_argument);
  auto grasp = request(Request::SET_GRASP);
  grasp.grasp.orientation.w = 1;
  grasp.grasp.position.z = -1000;
  EXPECT_THROW(edit_object(library_, grasp), std::invalid_argument);
  auto rename = request(Request::RENAME);
  EXPECT_THROW(edit_object(library_, rename), std::invalid_argument);
  rename.new_name = "../mug";
  EXPECT_THROW(edit_object(library_, rename), std::invalid_argument);
  test::expect_equal(stored(), before);
}

TEST_F(EditObject, NamesAnUnknownObject) {
  for (std::uint8_t command = Request::ENABLE; command <= Request::SET_SYMMETRY; ++command) {
    auto edit = request(command);
    edit.name = "wrench";
    edit.new_name = "pliers";
    edit.min_score = 0.5f;
    edit.grasp.orientation.w = 1;
    EXPECT_THROW(edit_object(library_, edit), std::invalid_argument) << int(command);
  }
}

}  // namespace
}  // namespace mbncc::nodelets
