// SPDX-License-Identifier: BSD-3-Clause
// Simulates days of operation in minutes: repeats a sequence of small images through all state that
// a nodelet keeps between images, with lessons, edits and clock jumps. Memory, open files and
// threads must stay constant. usage: soak FRAMES [CSV]
#include <cstdlib>
#include <iostream>
#include <opencv2/core/utility.hpp>

#include "mbncc/cell/frozen_image.hpp"
#include "mbncc/cell/pose_average.hpp"
#include "mbncc/cell/scene_watch.hpp"
#include "mbncc/cell/stamp_gate.hpp"
#include "mbncc/cell/tracker.hpp"
#include "mbncc/cell/video_search.hpp"
#include "mbncc/learning/learn_object.hpp"
#include "mbncc/library/object_library.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/sim/scene.hpp"
#include "support/process_state.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

constexpr double kFrameTime = 1. / 30;  // [s]
constexpr double kMostGrowth = 5;       // [MB]
constexpr int kRest = 40, kMove = 12;   // images of an object at rest, and of the arm
constexpr long kLessonEvery = 2000, kJumpEvery = 7000;  // images
constexpr long kSamples = 400;

sim::SceneConfig scene_config() {
  sim::SceneConfig config;
  config.size = {160, 120};
  return config;
}

/// An object lies at a place, an arm carries it to another one, it lies there, and the arm takes it
/// away.
class Story {
 public:
  Story() {
    rest(kFirst);
    reach(kFirst);
    rest(kSecond);
    reach(kSecond);
    for (int i = 0; i < kRest; ++i) images_.push_back(draw({}, {}));
  }

  const cv::Mat& image(long frame) const {
    return images_[static_cast<std::size_t>(frame) % images_.size()];
  }

  Lesson lesson() const {
    Lesson lesson;
    lesson.before = images_.front();
    lesson.after = images_.back();
    return lesson;
  }

 private:
  static constexpr Pose2D kFirst{60.3, 60.2, 0.4}, kSecond{105.6, 50.4, -1.1};
  static sim::Placed at(const Pose2D& pose) { return {{11, 45, 1.6}, pose}; }

  cv::Mat draw(const std::vector<sim::Placed>& placed, const std::optional<sim::Arm>& arm) {
    return scene_.render(placed, images_.size() + 1, arm);
  }
  void rest(const Pose2D& pose) {
    for (int i = 0; i < kRest; ++i) images_.push_back(draw({at(pose)}, {}));
  }
  void reach(const Pose2D& pose) {
    for (int i = 0; i < kMove; ++i) {
      const double y = pose.y + 10. * std::abs(kMove / 2 - i);
      images_.push_back(draw({at(pose)}, sim::Arm{{pose.x, y, -kPi / 2}, 30}));
    }
  }

  const sim::Scene scene_{scene_config()};
  std::vector<cv::Mat> images_;
};

class Cell {
 public:
  void show(long frame) {
    if (frame % kJumpEvery == kJumpEvery - 1) now_ = 1000;  // a bag that starts again
    now_ += kFrameTime;
    if (frame % kLessonEvery == 0) teach(frame / kLessonEvery);
    // Cloned, because every image from a camera has its own memory.
    const cv::Mat image = story_.image(frame).clone();
    if (gate_.judge(now_, now_) == StampGate::Verdict::kRestarted) start_over();
    if (frozen_.update(image)) throw std::runtime_error("live images are called frozen");
    watch_.update(now_, image);
    auto tracked = tracker_.update(now_, video_.find(matcher_, now_, image).matches);
    average_.apply(tracked);
    for (const auto& match : tracked) confirmed_ += match.state == TrackState::kConfirmed;
  }

  long confirmed() const { return confirmed_; }

 private:
  void start_over() {
    video_.reset();
    tracker_.reset();
    average_.reset();
  }

  void teach(long number) {
    Lesson lesson = story_.lesson();
    lesson.name = number % 2 == 0 ? "part" : "twin";
    const LearnResult learned = learn_object(lesson);
    if (!learned.has_model) throw std::runtime_error(learned.message);
    ObjectModel model = learned.object;
    model.enabled = number % 2 == 0;  // a twin would make both ambiguous
    library_.save(model, ObjectLibrary::Existing::kReplace);
    library_.edit(model.name, [&](ObjectModel& one) { one.label = std::to_string(number); });
    matcher_.set_objects(library_.load()->objects);
  }

  const Story story_;
  const TemporaryFolder folder_;
  ObjectLibrary library_{folder_.path()};
  Matcher matcher_;
  StampGate gate_{0.5, 0.1};
  FrozenImage frozen_;
  SceneWatch watch_;
  VideoSearch video_;
  InstanceTracker tracker_;
  PoseAverage average_{10};
  double now_ = 1000;  // [s]
  long confirmed_ = 0;
};

int run(long frames, const std::string& csv) {
  cv::setNumThreads(1);
  Cell cell;
  StateHistory history(csv);
  const long every = std::max(1L, frames / kSamples);
  for (long frame = 0; frame < frames; ++frame) {
    cell.show(frame);
    if (frame % every == 0) history.add(frame);
  }
  std::cout << frames << " images, confirmed in " << cell.confirmed() << ": " << history.growth()
            << " MB, " << history.new_files() << " open files and " << history.new_threads()
            << " threads more\n";
  const bool flat =
      history.growth() < kMostGrowth && history.new_files() <= 0 && history.new_threads() <= 0;
  return flat && cell.confirmed() > frames / 10 ? 0 : 1;
}

}  // namespace
}  // namespace mbncc::test

constexpr int kSkipped = 77;  // SKIP_RETURN_CODE of the test

int main(int argc, char** argv) {
  const long frames = argc > 1 ? std::atol(argv[1]) : 0;
  if (frames < 1000) {
    std::cerr << "usage: soak FRAMES [CSV]   (1000 frames at least)\n";
    return 2;
  }
  if (!mbncc::test::process_is_visible()) {
    std::cerr << "soak: skipped, /proc is not mounted\n";
    return kSkipped;
  }
  try {
    return mbncc::test::run(frames, argc > 2 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::cerr << "soak: " << error.what() << '\n';
    return 1;
  }
}
