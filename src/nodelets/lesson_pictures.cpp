// The pictures of a lesson: given with the goal, or waited for in the live cell.
#include <ros/time.h>

#include <chrono>
#include <thread>

#include "nodelets/images.hpp"
#include "nodelets/lesson.hpp"
#include "nodelets/lesson_stages.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;

constexpr std::chrono::milliseconds kGlance{30};  // between two looks at the live scene
constexpr int kGlancesPerWord = 15;               // between two messages to the operator

LessonPicture picture_of(const StillShot& shot, const std::string& frame_id) {
  LessonPicture picture{shot.picture, {}, shot.number};
  picture.header.stamp.fromSec(shot.stamp);
  picture.header.frame_id = frame_id;
  return picture;
}

}  // namespace

void LessonRun::take_pictures() {
  const bool change = goal_.mode == Goal::CHANGE;
  if (is_given(goal_.before))
    before_ = given(goal_.before, "before");
  else if (change && goal_.already_moved)
    take_already_moved();
  else
    before_ = wait_for_still();
  if (change && is_given(goal_.after)) after_ = given(goal_.after, "after");
  if (change && after_.picture.empty()) after_ = wait_for_change(before_.number);
}

bool LessonRun::waits_for_change() const {
  return goal_.mode == Goal::CHANGE && !is_given(goal_.after) && !goal_.already_moved;
}

LessonPicture LessonRun::given(const sensor_msgs::Image& image, const std::string& what) const {
  const Decoded decoded = decode_picture(image);
  if (!decoded) fail(LearnError::kEncoding, "Picture " + what + ": " + decoded.fault + ".");
  return {decoded.picture, image.header, 0};
}

void LessonRun::take_already_moved() {
  after_ = wait_for_still();
  const auto before = tools_.pictures.before_change();
  if (!before)
    fail(LearnError::kNoChange, "Nothing in the camera's view has changed lately.",
         "Teach without already_moved, and take the object away when told to.");
  before_ = picture_of(*before, after_.header.frame_id);
}

template <class Ready, class Say>
LessonPicture LessonRun::wait_until(const Ready& ready, const Say& say) {
  for (int glance = 0;; ++glance) {
    const PictureFeed::View view = tools_.pictures.look();
    if (const auto why = client_.interruption()) fail_waiting(*why, view);
    if (view.still && ready(*view.still)) return picture_of(*view.still, view.header.frame_id);
    if (glance % kGlancesPerWord == 0) {
      if (view.any_picture)
        say(view);
      else
        tell(Feedback::WAIT_IMAGE, 0, "Waiting for a picture from the camera.");
    }
    std::this_thread::sleep_for(kGlance);
  }
}

LessonPicture LessonRun::wait_for_still() {
  return wait_until([](const StillShot&) { return true; },
                    [this](const PictureFeed::View&) {
                      tell(Feedback::WAIT_IMAGE, 0.02,
                           "Waiting for a still scene: move arm and hands out.", true);
                    });
}

LessonPicture LessonRun::wait_for_change(std::uint64_t seen) {
  SceneChange change = SceneChange::kNone;
  const auto ready = [&](const StillShot& shot) {
    if (shot.number <= seen) return false;
    if (shot.picture.size() != before_.picture.size()) fail(LearnError::kImageMismatch);
    seen = shot.number;
    change = scene_change(before_.picture, shot.picture);
    return change == SceneChange::kInside;
  };
  return wait_until(ready, [&](const PictureFeed::View& view) {
    if (!view.still)
      tell(Feedback::WAIT_STILL, 0.2, "Something moves: leave the picture and keep still.", true);
    else if (change == SceneChange::kAtBorder)
      tell(Feedback::WAIT_STILL, 0.2, "Something reaches into the picture: move it out.", true);
    else
      tell(Feedback::WAIT_REMOVAL, 0.1, "Take the object away now.", true);
  });
}

void LessonRun::fail_waiting(LearnError interruption, const PictureFeed::View& view) const {
  if (interruption != LearnError::kTimeout) fail(interruption);
  if (!view.any_picture)
    fail(LearnError::kNoImage,
         view.fault.empty() ? "" : "No usable picture arrived: " + view.fault + ".");
  fail(view.still ? LearnError::kTimeout : LearnError::kNotStill);
}

}  // namespace mbncc::nodelets
