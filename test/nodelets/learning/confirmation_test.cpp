// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/confirmation.hpp"

#include <gtest/gtest.h>

#include <future>
#include <utility>

namespace mbncc::nodelets {
namespace {

using Request = Confirmation::Request;
using Response = Confirmation::Response;

constexpr std::chrono::minutes kPatience{1};

bool never() {
  return false;
}

Request command(std::uint8_t code) {
  Request request;
  request.command = code;
  return request;
}

TEST(Confirmation, RefusesWhileNoLessonWaits) {
  Confirmation desk;
  const Response response = desk.ask(command(Request::ACCEPT));
  EXPECT_FALSE(response.success);
  EXPECT_FALSE(response.message.empty());
}

TEST(Confirmation, CarriesCommandsAndAnswersAcross) {
  Confirmation desk;
  desk.open("goal");
  auto operator_side = std::async(std::launch::async, [&desk] {
    const Response first = desk.ask(command(Request::UNDO));
    return std::make_pair(first, desk.ask(command(Request::ACCEPT)));
  });
  for (const auto expected : {Request::UNDO, Request::ACCEPT}) {
    const auto request = desk.next(never, kPatience);
    ASSERT_TRUE(request);
    EXPECT_EQ(request->command, expected);
    Response response;
    response.success = true;
    response.message = std::to_string(expected);
    desk.answer(response);
  }
  const auto answers = operator_side.get();
  EXPECT_EQ(answers.first.message, std::to_string(Request::UNDO));
  EXPECT_EQ(answers.second.message, std::to_string(Request::ACCEPT));
}

TEST(Confirmation, RefusesACommandForAnotherLesson) {
  Confirmation desk;
  desk.open("earlier");
  desk.close();
  desk.open("goal");
  Request request = command(Request::ACCEPT);
  request.goal_id = "earlier";
  const Response refused = desk.ask(request);
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("another one waits"), std::string::npos);
  request.goal_id = "goal";
  auto operator_side = std::async(std::launch::async, [&] { return desk.ask(request); });
  ASSERT_TRUE(desk.next(never, kPatience));
  Response response;
  response.success = true;
  desk.answer(response);
  EXPECT_TRUE(operator_side.get().success);
}

TEST(Confirmation, EndsWhenInterrupted) {
  Confirmation desk;
  desk.open("goal");
  EXPECT_FALSE(desk.next([] { return true; }, kPatience));
}

TEST(Confirmation, EndsAfterTheTimeout) {
  Confirmation desk;
  desk.open("goal");
  EXPECT_FALSE(desk.next(never, std::chrono::milliseconds(1)));
}

TEST(Confirmation, ReleasesTheOperatorWhenTheLessonEnds) {
  Confirmation desk;
  desk.open("goal");
  auto operator_side =
      std::async(std::launch::async, [&desk] { return desk.ask(command(Request::ACCEPT)); });
  ASSERT_TRUE(desk.next(never, kPatience));
  desk.close();
  EXPECT_FALSE(operator_side.get().success);
}

TEST(Confirmation, AnAnswerGivenJustBeforeTheEndArrives) {
  Confirmation desk;
  desk.open("goal");
  auto operator_side =
      std::async(std::launch::async, [&desk] { return desk.ask(command(Request::ACCEPT)); });
  ASSERT_TRUE(desk.next(never, kPatience));
  Response response;
  response.success = true;
  desk.answer(response);
  desk.close();
  EXPECT_TRUE(operator_side.get().success);
}

}  // namespace
}  // namespace mbncc::nodelets
