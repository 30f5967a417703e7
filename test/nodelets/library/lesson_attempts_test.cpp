// SPDX-License-Identifier: BSD-3-Clause
// The last step of storing fails: the object is in place, but its folder is not synced.
#include "nodelets/library/lesson_attempts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>

#include "library/fault_injection.hpp"
#include "library/models.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using Existing = ObjectLibrary::Existing;
using Step = std::function<void(ObjectLibrary&)>;

class Attempts : public testing::Test {
 protected:
  /// Runs `step`; the last sync of what it does fails.
  void fail_at_the_end(const Step& step) {
    test::FaultPlan plan;
    plan.error = EIO;
    plan.at = last_sync_of(step);
    const test::ArmedFault fault(plan);
    EXPECT_THROW(step(library_), FileError);
  }
  std::shared_ptr<const ObjectModel> stored() { return library_.load()->find("cup"); }

  test::TemporaryFolder folder_;
  ObjectLibrary library_{folder_ / "library"};
  ObjectModel cup_ = test::random_model(1, "cup");
  LessonAttempts attempts_;

 private:
  /// Index of the last fsync() of `step`, which is tried in a library of its own.
  int last_sync_of(const Step& step) {
    const LessonAttempts before = attempts_;
    std::filesystem::copy(folder_ / "library", folder_ / "trial",
                          std::filesystem::copy_options::recursive);
    ObjectLibrary trial(folder_ / "trial");
    {
      const test::ArmedFault count{test::FaultPlan()};
      step(trial);
    }
    attempts_ = before;
    const auto& calls = test::fault_plan().calls;
    return static_cast<int>(
        std::distance(std::find(calls.rbegin(), calls.rend(), "fsync"), calls.rend()) - 1);
  }
};

TEST_F(Attempts, AnObjectThatIsInPlaceAlreadyIsAcceptedAgain) {
  fail_at_the_end(
      [&](ObjectLibrary& library) { attempts_.save(library, cup_, Existing::kRefuse); });
  ASSERT_TRUE(stored());
  ObjectModel corrected = test::random_model(2, "cup");
  corrected.learned_at = cup_.learned_at + 5;
  corrected.taught_by = cup_.taught_by;
  const ObjectModel again = attempts_.save(library_, corrected, Existing::kRefuse);
  EXPECT_EQ(again.views.size(), corrected.views.size());
  EXPECT_EQ(stored()->label, corrected.label);
}

TEST_F(Attempts, ANameThatAnotherLessonHasTakenIsRefused) {
  ObjectModel other = test::random_model(3, "cup");
  other.learned_at = cup_.learned_at - 60;
  other.taught_by = cup_.taught_by;
  library_.save(other, Existing::kRefuse);
  EXPECT_THROW(attempts_.save(library_, cup_, Existing::kRefuse), NameError);
  EXPECT_THROW(attempts_.save(library_, cup_, Existing::kRefuse), NameError) << "also repeatedly";
  EXPECT_EQ(stored()->learned_at, other.learned_at);
}

TEST_F(Attempts, TheFirstOneReplacesNothing) {
  library_.save(cup_, Existing::kRefuse);
  EXPECT_THROW(attempts_.save(library_, cup_, Existing::kRefuse), NameError);
}

TEST_F(Attempts, AViewThatIsInPlaceAlreadyIsNotAddedTwice) {
  library_.save(cup_, Existing::kRefuse);
  const std::size_t views = cup_.views.size();
  const View view = test::random_model(2).views.front();
  std::size_t seen = 0;
  const auto add = [&](ObjectLibrary& library) {
    attempts_.add_view(library, "cup", [&](ObjectModel& model) {
      seen = model.views.size();
      model.views.push_back(view);
    });
  };
  fail_at_the_end(add);
  ASSERT_EQ(stored()->views.size(), views + 1);
  add(library_);
  EXPECT_EQ(seen, views);
  EXPECT_EQ(stored()->views.size(), views + 1);
}

TEST_F(Attempts, TheViewOfAnotherLessonStays) {
  library_.save(cup_, Existing::kRefuse);
  std::size_t seen = 0;
  const auto add = [&](unsigned seed) {
    return [&seen, seed](ObjectModel& model) {
      seen = model.views.size();
      model.views.push_back(test::random_model(seed).views.front());
    };
  };
  attempts_.add_view(library_, "cup", add(2));
  library_.edit("cup", add(3));
  attempts_.add_view(library_, "cup", add(4));
  EXPECT_EQ(seen, cup_.views.size() + 2);
}

}  // namespace
}  // namespace mbncc::nodelets
