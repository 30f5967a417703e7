// SPDX-License-Identifier: BSD-3-Clause
// State of the lesson and its server, and the actions that are possible in it.
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <mbncc_vision/ConfirmLearning.h>
#include <mbncc_vision/LearnObjectActionFeedback.h>
#include <mbncc_vision/LearnObjectActionResult.h>
#include <mbncc_vision/LearnQuality.h>
#include <mbncc_vision/LearnedObject.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "console/words.hpp"

namespace mbncc::console {

/// How a goal ended. actionlib itself recalls a goal stamped before the last cancel request and
/// sends an empty result, whose error code reads SUCCESS; this function changes it to CANCELLED.
mbncc_vision::LearnObjectResult outcome_of(const mbncc_vision::LearnObjectActionResult& result);

/// All times are seconds of one steady clock.
class LessonModel {
 public:
  enum class Phase {
    kNoServer,  ///< no report from the learning nodelet
    kReady,     ///< a lesson may begin
    kRunning,   ///< a lesson waits for the scene, or computes
    kReview,    ///< the operator is asked
    kDeciding   ///< the answer was sent
  };

  using Word = mbncc_vision::ConfirmLearning::Request;

  /// Time without messages after which the server counts as stopped. [s]
  static constexpr double kSilence = 2.0;

  void take_status(const actionlib_msgs::GoalStatusArray& status, double now);
  void take_feedback(const mbncc_vision::LearnObjectActionFeedback& feedback, double now);
  void take_draft(const mbncc_vision::LearnObjectResult& draft);
  void take_result(const mbncc_vision::LearnObjectActionResult& result, double now);
  /// Takes the library's list of objects. Returns true if the object that was learned last has been
  /// deleted, renamed or replaced, so that the lesson's result is no longer shown.
  bool take_library(const std::vector<mbncc_vision::LearnedObject>& objects);

  /// The operator pressed Teach; `goal` is the id of the goal that was sent.
  void begin(const std::string& goal, double now);
  /// Takes a command of the operator. It is queued while an earlier one is carried out, so no
  /// stroke is lost.
  void want(const Word& word);
  /// The next command to send, which is then marked as sent; none if the queue is empty or the
  /// server is busy.
  std::optional<Word> next_word();
  /// Corrections that are not yet part of a draft, the oldest first.
  std::deque<Word> waiting() const;
  /// Whether the camera sends images.
  void take_camera(bool alive) { camera_alive_ = alive; }
  /// The operator accepts the draft although it is BAD; valid until the next draft.
  void insist(bool insisted) { insisted_ = insisted; }
  /// Takes the server's answer to the command.
  void take_answer(bool success, const std::string& message);
  /// The command got no answer: the server may have carried it out or not.
  void take_no_answer(const std::string& message);
  /// Call this several times per second.
  void look_at_clock(double now);

  Phase phase() const { return phase_; }
  bool may_teach() const { return phase_ == Phase::kReady; }
  bool may_cancel() const { return phase_ == Phase::kRunning; }
  bool may_decide() const { return phase_ == Phase::kReview; }
  /// A BAD draft can be accepted only after the operator has confirmed the check.
  bool may_accept() const { return may_decide() && draft_ && (acceptable_ || insisted_); }
  /// The draft may be corrected, also while a correction is computed.
  bool may_correct() const { return draft_.has_value(); }
  /// There may be a correction to undo, including corrections without an answer yet.
  bool may_undo() const;
  bool must_insist() const { return draft_.has_value() && !acceptable_; }
  /// The lesson waits for a change of the scene, so changes are shown in the image.
  bool waits_for_scene() const;

  const std::string& goal() const { return goal_; }
  /// Whether this window has begun the lesson with this goal: the newest one under way, or the last
  /// one. Another client may have begun one that this window only shows.
  bool is_own(const std::string& goal) const { return own_ && goal == goal_; }
  std::string headline() const;
  std::string detail() const;
  /// Level of the last lesson's result, or of the answer to the last command.
  Level level() const { return level_; }
  double progress() const { return progress_; }
  std::string time_left(double now) const;
  /// Result of the lesson in review; none without one.
  const std::optional<mbncc_vision::LearnObjectResult>& draft() const { return draft_; }
  /// Changes with every new draft().
  int draft_number() const { return draft_number_; }

 private:
  void join(const std::string& goal, double now);
  void show_draft(const std::optional<mbncc_vision::LearnObjectResult>& draft);
  void count_corrections(bool success);
  void go_on(bool success, const std::string& message);
  void withdraw_undo_of_refused();
  void end(const std::string& headline, const std::string& detail, Level level);
  void get_ready();
  bool under_way() const;

  /// The object that the last lesson stored.
  struct Learned {
    std::string name;
    std::uint32_t revision = 0;
    bool listed = false;  // the library has listed it
  };

  Phase phase_ = Phase::kNoServer;
  std::string goal_;
  bool own_ = false;  // begun by this window
  std::string headline_ = "Waiting for the learning nodelet";
  std::string question_;  // the server's message while it asks the operator
  std::string refusal_;   // answer to the last command, to be shown when the server asks again
  std::string detail_ = "Start it with cell.launch; this window continues automatically.";
  Level level_ = Level::kUnknown;
  std::uint8_t stage_ = 0;
  double progress_ = 0;
  double deadline_ = -1;
  double heard_ = -1e9;
  double goal_seen_ = 0;
  bool unheard_ = false;  // no feedback yet since the lesson was joined
  bool acceptable_ = false, insisted_ = false;
  bool camera_alive_ = true;
  std::deque<Word> words_;     // not yet sent
  std::optional<Word> asked_;  // sent, but not yet answered
  int corrections_ = 0;        // accepted by the server; < 0: unknown
  std::optional<mbncc_vision::LearnObjectResult> draft_, newest_draft_;
  int draft_number_ = 0;
  std::optional<Learned> learned_;
};

}  // namespace mbncc::console
