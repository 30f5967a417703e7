// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/lesson_storage.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "library/models.hpp"
#include "mbncc/learning/further_view.hpp"
#include "mbncc/sim/scene.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

LibrarySnapshot library_of(const std::vector<ObjectModel>& models) {
  LibrarySnapshot library;
  for (const auto& model : models)
    library.objects.push_back(std::make_shared<const ObjectModel>(model));
  return library;
}

ObjectModel named(const std::string& name) {
  ObjectModel model;
  model.name = model.label = name;
  return model;
}

LearnError error_of(const Lesson& lesson, Storing storing, const LibrarySnapshot& library) {
  const auto refusal = check_storing(lesson, storing, library);
  if (!refusal) return LearnError::kSuccess;
  EXPECT_FALSE(refusal->message.empty());
  EXPECT_FALSE(refusal->hint.empty());
  return refusal->error;
}

LearnError error_of(const std::string& name, Storing storing, const LibrarySnapshot& library) {
  Lesson lesson;
  lesson.name = name;
  return error_of(lesson, storing, library);
}

TEST(CheckStoring, NameMustFitTheKindOfStoring) {
  const LibrarySnapshot library = library_of({named("cup")});
  EXPECT_EQ(error_of("box", Storing::kNew, library), LearnError::kSuccess);
  EXPECT_EQ(error_of("cup", Storing::kNew, library), LearnError::kNameTaken);
  EXPECT_EQ(error_of("box", Storing::kReplace, library), LearnError::kSuccess);
  EXPECT_EQ(error_of("cup", Storing::kReplace, library), LearnError::kSuccess);
  EXPECT_EQ(error_of("box", Storing::kAddView, library), LearnError::kNameUnknown);
  EXPECT_EQ(error_of("cup", Storing::kAddView, library), LearnError::kSuccess);
  for (const Storing storing : {Storing::kNew, Storing::kReplace, Storing::kAddView})
    for (const char* name : {"", "../cup", "1cup", "a b"})
      EXPECT_EQ(error_of(name, storing, library), LearnError::kNameInvalid) << name;
}

TEST(CheckStoring, NameOfAnotherImageIsTaken) {
  LibrarySnapshot library = library_of({named("cup")});
  library.other_images = {"photo.png"};
  for (const Storing storing : {Storing::kNew, Storing::kReplace})
    EXPECT_EQ(error_of("photo", storing, library), LearnError::kNameTaken);
  EXPECT_EQ(error_of("box", Storing::kNew, library), LearnError::kSuccess);
}

TEST(CheckStoring, AFurtherViewMustNotContradictTheObject) {
  ObjectModel cup = named("cup");
  cup.object_height = 0.05;
  const LibrarySnapshot library = library_of({cup});
  Lesson lesson;
  lesson.name = lesson.label = "cup";
  lesson.object_height = 0.05;
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library), LearnError::kSuccess);
  lesson.object_height = 0.04;
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library), LearnError::kRegionInvalid);
  EXPECT_EQ(error_of(lesson, Storing::kReplace, library), LearnError::kSuccess);
  lesson.object_height = 0;
  lesson.symmetry = 2;
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library), LearnError::kRegionInvalid);
  EXPECT_EQ(error_of(lesson, Storing::kReplace, library), LearnError::kSuccess);
  cup.symmetry = 2;
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library_of({cup})), LearnError::kSuccess);
  lesson.symmetry.reset();
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library_of({cup})), LearnError::kSuccess);
  lesson.label = "Cup";
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library), LearnError::kNameInvalid);
  lesson.label = "";
  lesson.reference = Pose2D{};
  EXPECT_EQ(error_of(lesson, Storing::kAddView, library), LearnError::kRegionInvalid);
}

TEST(CheckStoring, LabelsAreChecked) {
  Lesson lesson;
  lesson.name = "cup";
  lesson.label = std::string(200, 'x');
  EXPECT_EQ(error_of(lesson, Storing::kNew, {}), LearnError::kSuccess);
  lesson.label += "x";
  EXPECT_EQ(error_of(lesson, Storing::kNew, {}), LearnError::kNameInvalid);
}

// The exception that the library throws for `change`.
template <class Change>
Refusal refusal_by(Change&& change) {
  try {
    change();
  } catch (const std::exception& failure) {
    return Refusal(failure);
  }
  return Refusal(LearnError::kSuccess);
}

TEST(LibraryRefusal, NameErrorsAreReportedForNamesOnly) {
  using Existing = ObjectLibrary::Existing;
  TemporaryFolder folder;
  ObjectLibrary library(folder.path());
  ObjectModel cup = random_model(1, "cup");
  library.save(cup, Existing::kRefuse);
  EXPECT_EQ(refusal_by([&] { library.save(cup, Existing::kRefuse); }).error,
            LearnError::kNameTaken);
  EXPECT_EQ(refusal_by([&] { library.edit("box", [](ObjectModel&) {}); }).error,
            LearnError::kNameUnknown);

  const Refusal crowded = refusal_by([&] {
    library.edit("cup", [](ObjectModel& model) { model.views.resize(65, model.views[0]); });
  });
  EXPECT_EQ(crowded.error, LearnError::kStorage) << crowded.message;
  EXPECT_NE(crowded.hint.find("fewer"), std::string::npos);
  cup.views[0].template_image = cv::Mat::zeros(4000, 4000, CV_8UC3);
  cup.views[0].map = cv::Mat(4000, 4000, CV_8UC1, cv::Scalar(255));
  cup.views[0].image_size = {5000, 5000};
  const Refusal large = refusal_by([&] { library.save(cup, Existing::kReplace); });
  EXPECT_EQ(large.error, LearnError::kStorage) << large.message;

  const Refusal broken = refusal_by([] { throw FileError("cup.png", "No space left on device"); });
  EXPECT_EQ(broken.error, LearnError::kStorage);
  EXPECT_NE(broken.hint.find("disk space"), std::string::npos);
  const Refusal told = refusal_by([] { throw FileError("cup", "is a file; give a folder"); });
  EXPECT_EQ(told.error, LearnError::kStorage);
  EXPECT_EQ(told.hint, "") << "the message says what to do";
  EXPECT_EQ(refusal_by([] { throw std::logic_error("a bug"); }).error, LearnError::kInternal);
}

class AddView : public testing::Test {
 protected:
  sim::Placed placed(std::uint64_t seed, const Pose2D& pose) const {
    sim::SceneObject object;
    object.seed = seed;
    return {object, pose};
  }

  ObjectModel learned(const sim::Placed& object, const cv::Mat& image) const {
    ObjectModel model = named("part");
    model.views = {crop_view(image, scene_.true_map(object), {1, 2, 3})};
    return model;
  }

  const sim::Scene scene_;
};

TEST_F(AddView, UsesFrameHeightAndSymmetryOfTheStoredObject) {
  const auto first = placed(5, {200, 200, 0}), second = placed(5, {420, 260, 2});
  ObjectModel stored = learned(first, scene_.render({first}, 1));
  stored.views[0].reference = first.pose;
  stored.object_height = 0.05;
  stored.symmetry = 2;
  stored.grasp = Grasp{{0.1, 0.2, 0.3}, {0, 0, 0, 1}};
  const cv::Mat image = scene_.render({second}, 2);
  ObjectModel lesson = learned(second, image);
  lesson.quality.verdict = Verdict::kMarginal;
  lesson.quality.reasons = {"nearly_round"};
  lesson.quality.advice = {"Declare it."};
  ASSERT_FALSE(add_view(stored, lesson, image));
  ASSERT_EQ(stored.views.size(), 2u);
  EXPECT_NEAR(stored.views[1].reference.x, 420, 1);
  EXPECT_NEAR(stored.views[1].reference.y, 260, 1);
  EXPECT_NEAR(angle_distance(stored.views[1].reference.theta, 2), 0, to_radians(1.5));
  EXPECT_EQ(stored.object_height, 0.05);
  EXPECT_EQ(stored.symmetry, 2);
  EXPECT_EQ(stored.quality.verdict, Verdict::kMarginal);
  EXPECT_TRUE(stored.quality.reasons.empty()) << "the symmetry is declared already";
  ASSERT_TRUE(stored.grasp);
  EXPECT_EQ(stored.grasp->position[0], 0.1);
}

TEST_F(AddView, RefusesAViewThatIsAlreadyStored) {
  const auto first = placed(5, {200, 200, 0});
  ObjectModel stored = learned(first, scene_.render({first}, 1));
  const cv::Mat again = scene_.render({first}, 2);
  const auto refusal = add_view(stored, learned(first, again), again);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->error, LearnError::kAlreadyKnown);
  EXPECT_EQ(stored.views.size(), 1u);
  const cv::Mat dim = 0.6 * again;
  EXPECT_FALSE(add_view(stored, learned(first, dim), dim)) << "another light is another view";
}

TEST_F(AddView, RefusesAnotherObjectAndChangesNothing) {
  const auto first = placed(5, {200, 200, 0}), other = placed(77, {420, 260, 0});
  ObjectModel stored = learned(first, scene_.render({first}, 1));
  const cv::Mat image = scene_.render({other}, 2);
  const auto refusal = add_view(stored, learned(other, image), image);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->error, LearnError::kNotDistinct);
  EXPECT_NE(refusal->hint.find("Teach another side under its own name"), std::string::npos);
  EXPECT_EQ(stored.views.size(), 1u);
}

TEST_F(AddView, ARefusalIsReportedBeforeConfirmation) {
  const auto first = placed(5, {200, 200, 0}), other = placed(77, {420, 260, 0});
  const auto moved = placed(5, {420, 260, 2});
  const ObjectModel stored = learned(first, scene_.render({first}, 1));
  const cv::Mat wrong = scene_.render({other}, 2), right = scene_.render({moved}, 3);
  ObjectModel lesson = learned(other, wrong);
  EXPECT_TRUE(try_view(lesson, stored, wrong));
  EXPECT_EQ(lesson.quality.verdict, Verdict::kBad);
  EXPECT_EQ(lesson.quality.reasons, std::vector<std::string>{"view_refused"});
  EXPECT_NE(lesson.quality.advice.at(0).find("was not found in the new image"), std::string::npos);
  lesson = learned(moved, right);
  EXPECT_FALSE(try_view(lesson, stored, right));
  EXPECT_EQ(lesson.quality.verdict, Verdict::kGood);
  EXPECT_TRUE(lesson.quality.advice.empty());
  EXPECT_EQ(stored.views.size(), 1u);
}

/// A bar in `image`, 120 px long and `longer`, at 30 degrees if `rotated`; its mark at one end
/// differs by `mark` grey levels.
ObjectModel bar(cv::Mat& image, bool rotated, double mark, int longer = 0) {
  const auto drawn = [&](const cv::Rect& box, cv::Scalar colour, cv::Mat& on) {
    const double angle = rotated ? to_radians(30) : 0;
    std::vector<cv::Point> corners;
    for (const cv::Point2d p : {cv::Point2d(box.x, box.y), cv::Point2d(box.x, box.br().y),
                                cv::Point2d(box.br()), cv::Point2d(box.br().x, box.y)}) {
      const cv::Point2d at = cv::Point2d(160, 120) + rotate(p, angle);
      corners.emplace_back(cvRound(at.x), cvRound(at.y));
    }
    cv::fillPoly(on, std::vector<std::vector<cv::Point>>{corners}, colour, cv::LINE_AA);
  };
  cv::Mat radiance(240, 320, CV_8UC3, cv::Scalar(150, 150, 150));
  cv::Mat map = cv::Mat::zeros(radiance.size(), CV_8UC1);
  const cv::Rect body(-60, -15, 120 + longer, 30);
  const cv::Scalar red(40, 60, 170);
  drawn(body, red, radiance);
  drawn(body, cv::Scalar(255), map);
  drawn({25, -9, 22, 18}, red + cv::Scalar::all(mark), radiance);
  radiance.convertTo(radiance, CV_32F);
  image = exposed(radiance, rotated ? 2 : 1);
  ObjectModel model;
  model.name = model.label = "bar";
  model.views = {crop_view(image, map > 127, {160, 120, 0})};
  return model;
}

TEST(AddViewOfABar, AtTwoAnglesIsRefused) {
  cv::Mat before, later;
  ObjectModel stored = bar(before, false, 20);
  const ObjectModel lesson = bar(later, true, 0);
  const auto refusal = add_view(stored, lesson, later);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->error, LearnError::kNotDistinct);
  EXPECT_NE(refusal->message.find("two angles"), std::string::npos);
  EXPECT_EQ(stored.views.size(), 1u);
}

TEST(AddViewOfABar, ThatIsNotGraspableIsMarginal) {
  cv::Mat before, same, longer;
  const ObjectModel stored = bar(before, false, 80);
  ObjectModel right = bar(same, true, 80), wrong = bar(longer, true, 80, 14);
  EXPECT_FALSE(try_view(right, stored, same));
  EXPECT_EQ(right.quality.verdict, Verdict::kGood);
  EXPECT_FALSE(try_view(wrong, stored, longer));
  EXPECT_EQ(wrong.quality.verdict, Verdict::kMarginal);
  EXPECT_EQ(wrong.quality.reasons, std::vector<std::string>{"view_uncertain"});
  ObjectModel accepted = stored;
  EXPECT_FALSE(add_view(accepted, wrong, longer));
  EXPECT_EQ(accepted.quality.advice.size(), 1u) << "it was doubted in the review already";
}

}  // namespace
}  // namespace mbncc::test
