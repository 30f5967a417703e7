#include "console/console_widget.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "console/detections_view.hpp"
#include "console/lamp_row.hpp"
#include "console/lesson_bar.hpp"
#include "console/library_strip.hpp"
#include "console/picture_view.hpp"
#include "console/review_pane.hpp"

namespace mbncc::console {
namespace {

using Confirm = mbncc_vision::ConfirmLearning::Request;

constexpr int kTick = 200;  // [ms]

// As the preview draws them.
double axes_length(const QImage& picture) {
  return std::max(30.0, picture.width() / 16.0);
}

}  // namespace

ConsoleWidget::ConsoleWidget(const Names& names, QWidget* parent)
    : QWidget(parent),
      lamp_row_(new LampRow),
      lesson_bar_(new LessonBar),
      picture_(new PictureView),
      review_(new ReviewPane),
      strip_(new LibraryStrip),
      detections_(new DetectionsView) {
  clock_.start();
  live_ = LivePicture(now());
  lay_out();
  connect_lesson();
  connect_operator();
  connect_library();
  connect_cell();
  connect(&timer_, &QTimer::timeout, this, &ConsoleWidget::look_at_clock);
  timer_.start(kTick);
  look_at_clock();
  ros_.connect_to(names);
  lamps_ = Lamps(ros_.cell());
  ros_.list_objects();
}

ConsoleWidget::~ConsoleWidget() = default;

void ConsoleWidget::lay_out() {
  auto* left = new QVBoxLayout;
  left->addWidget(lesson_bar_);
  left->addWidget(picture_, 1);
  auto* upper = new QHBoxLayout;
  upper->addLayout(left, 1);
  upper->addWidget(review_);
  auto* lower = new QHBoxLayout;
  lower->addWidget(strip_, 3);
  lower->addWidget(detections_, 4);
  strip_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  detections_->setFixedHeight(strip_->sizeHint().height());
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(6, 6, 6, 6);
  all->addWidget(lamp_row_);
  all->addLayout(upper, 1);
  all->addLayout(lower);
}

void ConsoleWidget::connect_lesson() {
  connect(&ros_, &RosLink::status_heard, this, [this](const auto& status) {
    const bool was_gone = lesson_.phase() == LessonModel::Phase::kNoServer;
    lesson_.take_status(status, now());
    // A nodelet that came back may hold other objects.
    if (was_gone) ros_.list_objects();
    show_lesson();
  });
  connect(&ros_, &RosLink::feedback_heard, this, [this](const auto& feedback) {
    lesson_.take_feedback(feedback, now());
    show_lesson();
  });
  connect(&ros_, &RosLink::draft_heard, this, [this](const auto& draft) {
    lesson_.take_draft(draft);
    show_lesson();
  });
  connect(&ros_, &RosLink::result_heard, this, [this](const auto& result) {
    lesson_.take_result(result, now());
    if (outcome_of(result).error_code == mbncc_vision::LearnObjectResult::SUCCESS)
      lesson_bar_->clear_name();
    show_lesson();
  });
  connect(&ros_, &RosLink::confirmed, this, [this](bool success, const QString& message) {
    lesson_.take_answer(success, message.toStdString());
    show_lesson();
  });
  connect(&ros_, &RosLink::grasp_marked, this,
          [this](bool success, const QString& message) { tell(success, "Grasp: " + message); });
  connect(&ros_, &RosLink::score_map_heard, review_, &ReviewPane::show_score_map);
}

void ConsoleWidget::connect_operator() {
  connect(lesson_bar_, &LessonBar::teach_wanted, this, &ConsoleWidget::teach);
  connect(lesson_bar_, &LessonBar::cancel_wanted, this, [this] { ros_.cancel(lesson_.goal()); });
  connect(lesson_bar_, &LessonBar::mark_wanted, this, [this] { ros_.mark_grasp(); });
  connect(picture_, &PictureView::corrected, this, &ConsoleWidget::send);
  connect(review_, &ReviewPane::decided, this, [this](int command) {
    Confirm request;
    request.command = static_cast<std::uint8_t>(command);
    send(request);
  });
  connect(review_, &ReviewPane::insisted, this, [this](bool insisted) {
    lesson_.insist(insisted);
    show_lesson();
  });
  connect(review_, &ReviewPane::tool_chosen, this, [this](int tool) {
    picture_->tool().choose(static_cast<Tool>(tool));
    picture_->update();
  });
  connect(review_, &ReviewPane::stroke_width_chosen, this,
          [this](int width) { picture_->tool().set_stroke_width(width); });
}

void ConsoleWidget::connect_library() {
  connect(&ros_, &RosLink::objects_listed, this, [this](const auto& objects) {
    library_.set_objects(objects);
    const auto enabled = std::count_if(objects.begin(), objects.end(),
                                       [](const auto& object) { return object.enabled; });
    lamps_.take_library(objects.size(), static_cast<std::size_t>(enabled));
    strip_->show_objects(library_);
  });
  connect(&ros_, &RosLink::edited, this, &ConsoleWidget::take_edit);
  connect(strip_, &LibraryStrip::edit_wanted, this,
          [this](const auto& request) { ros_.edit(request); });
  connect(strip_, &LibraryStrip::symmetry_wanted, this,
          [this](const QString& name, std::uint8_t symmetry) {
            ros_.edit(library_.declare(name.toStdString(), symmetry));
          });
  connect(strip_, &LibraryStrip::undo_wanted, this, &ConsoleWidget::undo_edit);
}

void ConsoleWidget::connect_cell() {
  connect(&ros_, &RosLink::detections_heard, this, [this](const auto& detections, double age) {
    detections_at_ = now();
    lamps_.take_detections(detections, now());
    detections_->show_detections(detections, age);
  });
  connect(&ros_, &RosLink::diagnostics_heard, this,
          [this](const auto& diagnostics) { lamps_.take_diagnostics(diagnostics, now()); });
  connect(&ros_, &RosLink::picture_heard, this, [this](const QImage& picture) {
    lamps_.take_picture(now());
    show_live(picture, false);
  });
  connect(&ros_, &RosLink::overlay_heard, this,
          [this](const QImage& picture) { show_live(picture, true); });
}

void ConsoleWidget::tell(bool success, const QString& sentence) {
  lesson_bar_->say({success ? Level::kGood : Level::kBad, sentence.toStdString()}, now());
}

void ConsoleWidget::teach() {
  if (!lesson_.may_teach()) return;
  lesson_.begin(ros_.teach(lesson_bar_->goal()), now());
  show_lesson();
}

void ConsoleWidget::send(const Confirm& request) {
  if (!lesson_.may_decide()) return;
  lesson_.decide();
  show_lesson();
  ros_.confirm(request);
}

void ConsoleWidget::take_edit(const mbncc_vision::EditObject::Request& request, bool success,
                              const QString& message) {
  const bool undone = undoing_;
  undoing_ = false;
  if (!success) tell(false, "Library: " + message);
  if (undone)
    library_.undone();
  else if (success)
    library_.done(request);
  strip_->show_objects(library_);
}

void ConsoleWidget::undo_edit() {
  if (!library_.can_undo() || undoing_) return;
  undoing_ = true;
  ros_.edit(library_.undo());
}

void ConsoleWidget::look_at_clock() {
  const auto before = lesson_.phase();
  lesson_.look_at_clock(now());
  // A server that hangs must not hold up the calls to the one that follows.
  if (lesson_.phase() == LessonModel::Phase::kNoServer && lesson_.phase() != before) {
    ros_.give_up();
    lamps_.forget_library();
  }
  lamp_row_->show_lamps(lamps_.look(now()));
  if (now() - detections_at_ > Lamps::kSilence) detections_->clear_rows();
  // A picture that stands still must not pass for the live one.
  if (!lesson_.draft() && live_.age(now()) > Lamps::kSilence)
    picture_->show_age(QString("OLD PICTURE: nothing has arrived for %1 s")
                           .arg(static_cast<int>(live_.age(now()))));
  show_lesson();
}

void ConsoleWidget::show_lesson() {
  lesson_bar_->show_lesson(lesson_, now());
  review_->show_lesson(lesson_);
  ros_.show_changes(lesson_.waits_for_scene());
  if (lesson_.draft_number() == draft_shown_) return;
  draft_shown_ = lesson_.draft_number();
  if (lesson_.draft()) show_draft(*lesson_.draft());
}

void ConsoleWidget::show_draft(const mbncc_vision::LearnObjectResult& draft) {
  const QImage preview = to_qimage(to_rgb(draft.preview));
  picture_->tool().set_axes(draft.object.reference, axes_length(preview));
  picture_->show_picture(preview, "The lesson's outline: accept it, or draw to correct it");
}

void ConsoleWidget::show_live(const QImage& picture, bool searched) {
  if (lesson_.draft()) return;
  const bool teaching = lesson_.phase() == LessonModel::Phase::kRunning;
  if (!live_.take(searched, teaching, now())) return;
  picture_->show_picture(picture, searched                    ? "Live, with what is found"
                                  : lesson_.waits_for_scene() ? "Live, changes tinted orange"
                                                              : "Live");
}

}  // namespace mbncc::console
