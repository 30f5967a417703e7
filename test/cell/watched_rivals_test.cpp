// SPDX-License-Identifier: BSD-3-Clause
// An instance that the video search reports as graspable is also graspable in a search of the whole
// image: simulated sequences of look-alikes, with late and lost images and a small search budget
// per image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "cell/watched_scene.hpp"
#include "mbncc/cell/video_search.hpp"

namespace mbncc {
namespace {

const cv::Size kSmall(208, 160);     // [px]
constexpr int kImagesOfAStory = 60;  // number of images shown to one VideoSearch
constexpr double kNear = 4;          // [px] distance at which both searches report the same place
constexpr double kSize = 0.02;       // relative error of a match's scale
// Variation of a margin between images that is caused by noise.
constexpr double kNoise = 3;  // log-odds

/// The number in an environment variable, or `otherwise`.
int number(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

struct Kind {
  sim::SceneObject drawing;
  std::string name;
};

/// Two names for one object, one of them drawn slightly smaller, and another object.
std::vector<Kind> look_alikes(std::uint64_t seed, const std::string& suffix = "") {
  const sim::SceneObject twin{seed, 44, 1.5};
  return {{twin, "one" + suffix},
          {twin, "other" + suffix},
          {{seed, 41, 1.5}, "smaller" + suffix},
          {{seed + 1, 40, 1.3}, "own" + suffix}};
}

/// A large library has look-alikes of two shapes.
std::vector<Kind> kinds_of(std::uint64_t seed, bool large_library) {
  std::vector<Kind> kinds = look_alikes(seed);
  if (large_library)
    for (const Kind& kind : look_alikes(seed + 20, "_of_second_shape")) kinds.push_back(kind);
  return kinds;
}

std::shared_ptr<const ObjectModel> taught(const Kind& kind) {
  sim::SceneConfig config;
  config.size = kSmall;
  const sim::Scene scene(config);
  const sim::Placed placed{kind.drawing, {104, 80, 0}};
  auto model = std::make_shared<ObjectModel>();
  model->name = kind.name;
  model->views = {crop_view(scene.render({placed}, 1), scene.true_map(placed), placed.pose)};
  return model;
}

enum class Shown { kFewObjects, kLargeLibrary, kRegion };

/// A region [px] of the image.
cv::Rect any_region(cv::RNG random) {
  const cv::Size size(random.uniform(60, 180), random.uniform(60, 140));
  return {random.uniform(0, kSmall.width - size.width),
          random.uniform(0, kSmall.height - size.height), size.width, size.height};
}

class Story {
 public:
  explicit Story(std::uint64_t seed, Shown shown = Shown::kFewObjects)
      : random_(seed), kinds_(kinds_of(100 + seed % 7, shown == Shown::kLargeLibrary)) {
    if (shown == Shown::kRegion) request_.roi = any_region(cv::RNG(seed));
    sim::SceneConfig config;
    config.size = kSmall;
    config.seed = seed;
    scene_ = std::make_unique<sim::Scene>(config);
    for (const auto& kind : kinds_) models_.push_back(taught(kind));
    matcher_.set_objects(models_);
    const double efforts[] = {0.1, 0.4, 0.8, 2}, sweeps[] = {0.5, 5, 60};
    video_ = VideoSearch({sweeps[random_.uniform(0, 3)], efforts[random_.uniform(0, 4)]});
    for (int i = random_.uniform(1, 4); i > 0; --i) put();
  }

  /// Shows the next image; true if the video search reports an instance as graspable and the whole
  /// search contradicts it.
  bool step() {
    for (int unseen = random_.uniform(0, 10) == 0 ? random_.uniform(1, 6) : 1; unseen > 0; --unseen)
      happen();
    now_ += random_.uniform(0, 8) == 0 ? random_.uniform(0.1, 2.0) : 1. / 30;
    image_ = scene_->render(placed_, static_cast<std::uint64_t>(frames_++), arm_) * gain_;
    result_ = video_.find(matcher_, now_, image_, request_);
    whole_ = count_graspable() > 0 ? matcher_.find(image_) : SearchResult{};
    return std::any_of(result_.matches.begin(), result_.matches.end(), [this](const Match& match) {
      return match.graspable && is_denied(match) && !is_overlooked(match);
    });
  }

  int count_graspable() const {
    return static_cast<int>(std::count_if(result_.matches.begin(), result_.matches.end(),
                                          [](const auto& match) { return match.graspable; }));
  }

  std::string text() const {
    std::string text;
    for (const auto* result : {&result_, &whole_}) {
      text += result == &result_ ? "watched:" : "\nwhole:";
      for (const auto& match : result->matches)
        text += ' ' + match.name + " at " + std::to_string(match.pose.x) + ", " +
                std::to_string(match.pose.y) + " margin " + std::to_string(match.margin_place) +
                " scale " + std::to_string(match.scale) + (match.graspable ? " graspable" : "") +
                (match.fresh ? " fresh" : "");
    }
    for (const auto& reason : result_.skipped) text += "\nskipped: " + reason;
    text += "\nlibrary:";
    for (const auto& object : matcher_.objects()) text += ' ' + object->name;
    for (const auto& placed : placed_)
      text += "\nlies: " + std::to_string(placed.object.seed) + ' ' +
              std::to_string(placed.object.diameter) + " at " + std::to_string(placed.pose.x) +
              ", " + std::to_string(placed.pose.y);
    return text;
  }

 private:
  void put() { placed_.push_back({kinds_[any_kind()].drawing, pose()}); }

  std::size_t any_kind() {
    return static_cast<std::size_t>(random_.uniform(0, static_cast<int>(kinds_.size())));
  }

  Pose2D pose() {
    return {random_.uniform(25., kSmall.width - 25.), random_.uniform(25., kSmall.height - 25.),
            random_.uniform(-kPi, kPi)};
  }

  void happen() {
    if (arm_) {
      arm_->grip.x += random_.uniform(-15., 15.);
      arm_->grip.y += random_.uniform(-15., 15.);
      if (random_.uniform(0, 6) == 0) arm_.reset();
    }
    const auto chosen =
        placed_.empty()
            ? 0
            : static_cast<std::size_t>(random_.uniform(0, static_cast<int>(placed_.size())));
    switch (random_.uniform(0, 40)) {
      case 0:
        if (placed_.size() < 4) put();
        break;
      case 1:
        if (!placed_.empty()) placed_.erase(placed_.begin() + static_cast<std::ptrdiff_t>(chosen));
        break;
      case 2:
        if (!placed_.empty()) placed_[chosen].pose = pose();
        break;
      case 3:
        if (!placed_.empty()) placed_[chosen].object = kinds_[any_kind()].drawing;
        break;
      case 4:
      case 5:
        arm_ = sim::Arm{pose(), 40};
        break;
      case 6:
        gain_ = random_.uniform(0.85, 1.1);
        break;
      case 7:
        forget_or_recall(models_[any_kind()]);
        break;
      default:
        break;
    }
  }

  void forget_or_recall(const std::shared_ptr<const ObjectModel>& model) {
    auto objects = matcher_.objects();
    const auto at = std::find(objects.begin(), objects.end(), model);
    if (at == objects.end())
      objects.push_back(model);
    else
      objects.erase(at);
    matcher_.set_objects(objects);
  }

  /// The whole search finds nothing of that name at the place, or a competitor or another angle
  /// that is about as likely.
  bool is_denied(const Match& match) const {
    for (const auto& other : whole_.matches)
      if (other.name == match.name &&
          cv::norm(other.pose.position() - match.pose.position()) < kNear)
        return other.ambiguous &&
               (other.margin_place < matcher_.config().min_margin_place - kNoise ||
                other.margin_angle < matcher_.config().min_margin_angle - kNoise);
    return true;
  }

  /// The object, drawn in the reported size, is at the place, no other object in the library
  /// searches the same, and the whole search has missed it: the match was verified on the same
  /// pixels before.
  bool is_overlooked(const Match& match) const {
    const auto objects = matcher_.objects();
    const auto drawn_as = [&](const std::string& name) {
      return std::find_if(kinds_.begin(), kinds_.end(),
                          [&](const auto& kind) { return kind.name == name; })
          ->drawing;
    };
    const auto same = [](const sim::SceneObject& a, const sim::SceneObject& b) {
      return a.seed == b.seed && a.diameter == b.diameter;
    };
    const sim::SceneObject drawing = drawn_as(match.name);
    const auto others_like = [&](const sim::SceneObject& lying) {
      return std::any_of(objects.begin(), objects.end(), [&](const auto& object) {
        return object->name != match.name && same(drawn_as(object->name), lying);
      });
    };
    return !others_like(drawing) &&
           std::any_of(placed_.begin(), placed_.end(), [&](const sim::Placed& placed) {
             const double size = match.scale * drawing.diameter / placed.object.diameter;
             return placed.object.seed == drawing.seed && std::abs(size - 1) < kSize &&
                    !others_like(placed.object) &&
                    cv::norm(placed.pose.position() - match.pose.position()) < kNear;
           });
  }

  cv::RNG random_;
  std::vector<Kind> kinds_;
  std::unique_ptr<sim::Scene> scene_;
  std::vector<std::shared_ptr<const ObjectModel>> models_;
  Matcher matcher_;
  VideoSearch video_;
  SearchRequest request_;
  std::vector<sim::Placed> placed_;
  std::optional<sim::Arm> arm_;
  double gain_ = 1, now_ = 0;
  int frames_ = 0;
  cv::Mat image_;
  SearchResult result_, whole_;
};

/// Shows `images` images of stories, starting with story `first`. Returns the number of graspable
/// instances.
int show(int first, int images, Shown mode = Shown::kFewObjects) {
  int graspable = 0;
  for (int shown = 0, story = first; shown < images; ++story) {
    Story cell(static_cast<std::uint64_t>(story), mode);
    for (int i = 0; i < kImagesOfAStory && shown < images; ++i, ++shown) {
      if (cell.step()) ADD_FAILURE() << "story " << story << ", image " << i << '\n' << cell.text();
      graspable += cell.count_graspable();
    }
  }
  return graspable;
}

TEST(WatchedRivals, GraspableInstancesPassAFullSearch) {
  const int images = number("MBNCC_IMAGES", 400);
  const int graspable = show(number("MBNCC_FIRST_STORY", 1), images);
  std::cout << images << " images, " << graspable << " graspable instances\n";
  EXPECT_GT(graspable, 0);
}

// Of more than a few objects, a search examines only places that have the colours of an object.
TEST(WatchedRivals, GraspableInstancesOfALargeLibraryPassAFullSearch) {
  const int images = number("MBNCC_IMAGES", 200);
  const int graspable = show(number("MBNCC_FIRST_STORY", 1), images, Shown::kLargeLibrary);
  std::cout << images << " images, " << graspable << " graspable instances\n";
  EXPECT_GT(graspable, 0);
}

TEST(WatchedRivals, GraspableInstancesInARegionPassAFullSearch) {
  const int images = number("MBNCC_IMAGES", 400);
  const int graspable = show(number("MBNCC_FIRST_STORY", 1), images, Shown::kRegion);
  std::cout << images << " images, " << graspable << " graspable instances\n";
  EXPECT_GT(graspable, 0);
}

/// A sequence in which an earlier version missed a look-alike.
struct Sequence {
  const char* name;
  int story;
};

class WatchedSequence : public testing::TestWithParam<Sequence> {};

TEST_P(WatchedSequence, TheLookAlikeCompetes) {
  EXPECT_GT(show(GetParam().story, kImagesOfAStory), 0);
}

INSTANTIATE_TEST_SUITE_P(
    ALookAlike, WatchedSequence,
    testing::Values(
        // A search of its region does not propose the twin anywhere near it.
        Sequence{"that_a_search_passes_over", 313},
        // An instance replaces its look-alike, which was found in darker images.
        Sequence{"of_an_earlier_image", 2881},
        // Only the look-alike has been searched in the whole image since more places resemble both.
        Sequence{"with_more_clutter", 1621},
        // Only the refinement of one name reaches the size in which the object appears.
        Sequence{"in_another_size", 20871},
        // An instance replaces one pose of its look-alike, which lies below it as well.
        Sequence{"replaced_beside_it", 90851}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace mbncc
