// SPDX-License-Identifier: BSD-3-Clause
#include "console/console_widget.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "console/calibration/calibration_pane.hpp"
#include "console/detections/detections_view.hpp"
#include "console/detections/lamp_row.hpp"
#include "console/explain/explain_pane.hpp"
#include "console/image/image_view.hpp"
#include "console/image/scaled_image.hpp"
#include "console/lesson/lesson_bar.hpp"
#include "console/lesson/object_name.hpp"
#include "console/lesson/review_pane.hpp"
#include "console/library/library_controller.hpp"
#include "console/library/library_strip.hpp"
#include "console/thresholds/threshold_controller.hpp"
#include "console/thresholds/threshold_pane.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

using Confirm = mbncc_vision::ConfirmLearning::Request;
using Result = mbncc_vision::LearnObjectResult;
using What = TeachingWish::What;

constexpr int kTick = 200;       // [ms]
constexpr int kSideWidth = 400;  // [px] at least
constexpr double kStep = 1.25;   // zoom factor per key press
constexpr const char* kRegionTip = "Draw a box; nothing is searched outside of it";
constexpr const char* kLessonCaption = "Still image: before the object left";

// The same length as in the lesson's preview.
double axes_length(const QSize& image) {
  return std::max(30.0, image.width() / 16.0);
}

}  // namespace

ConsoleWidget::ConsoleWidget(const Names& names, QWidget* parent)
    : QWidget(parent),
      lamp_row_(new LampRow),
      lesson_bar_(new LessonBar),
      image_(new ImageView),
      review_(new ReviewPane),
      explanation_(new ExplainPane),
      threshold_pane_(new ThresholdPane),
      calibration_(new CalibrationPane),
      strip_(new LibraryStrip),
      detections_(new DetectionsView),
      side_(new QStackedWidget),
      cell_page_(new QWidget) {
  library_ = new LibraryController(ros_, *strip_, this);
  threshold_controller_ = new ThresholdController(ros_, *threshold_pane_, *image_, this);
  clock_.start();
  live_ = LiveImage(now());
  lay_out();
  make_shortcuts();
  connect_lesson();
  connect_operator();
  connect_library();
  connect_cell();
  connect_explanation();
  connect_calibration();
  connect_region();
  connect(&timer_, &QTimer::timeout, this, &ConsoleWidget::look_at_clock);
  timer_.start(kTick);
  look_at_clock();
  lesson_bar_->take_keyboard();
  ros_.connect_to(names);
  lamps_ = Lamps(ros_.cell());
  ros_.list_objects();
}

ConsoleWidget::~ConsoleWidget() = default;

// The image takes all space that the other widgets leave.
void ConsoleWidget::lay_out() {
  auto* left = new QVBoxLayout;
  left->setSpacing(3);
  left->addWidget(image_, 1);
  left->addWidget(make_image_bar());
  auto* cell = new QVBoxLayout(cell_page_);
  cell->setContentsMargins(0, 0, 0, 0);
  cell->addWidget(detections_, 1);
  cell->addWidget(strip_, 1);
  side_->addWidget(cell_page_);
  side_->addWidget(review_);
  side_->addWidget(explanation_);
  side_->addWidget(threshold_pane_);
  side_->addWidget(calibration_);
  side_->setFixedWidth(kSideWidth);
  // Queued, because the signal is emitted while the layout is being computed.
  connect(image_, &ImageView::shape_changed, this, &ConsoleWidget::fit_side, Qt::QueuedConnection);
  auto* middle = new QHBoxLayout;
  middle->addLayout(left, 1);
  middle->addWidget(side_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(6, 4, 6, 4);
  all->setSpacing(3);
  all->addWidget(lamp_row_);
  all->addWidget(lesson_bar_);
  all->addLayout(middle, 1);
}

/// Gives the side pane the width that the image's aspect ratio leaves free.
void ConsoleWidget::fit_side() {
  const QSize shape = image_->shape();
  if (shape.isEmpty()) return;
  const int both = image_->width() + side_->width();
  const int left = both - image_->height() * shape.width() / shape.height();
  side_->setFixedWidth(std::clamp(left, kSideWidth, std::max(kSideWidth, both / 2)));
}

QWidget* ConsoleWidget::make_image_bar() {
  auto* bar = new QWidget;
  marks_ = make_button("Hide marks", "Outlines and labels hide the image below them", "H");
  marks_->setCheckable(true);
  fit_ = make_button("Show all", "The wheel or + zooms, dragging or arrow keys pan", "0");
  why_ = make_button("Why not found here?", "Then click the place in the image", "W");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(marks_);
  row->addWidget(fit_);
  row->addStretch(1);
  thresholds_ = make_button("Thresholds", "The effect of other thresholds in this image", "S");
  camera_ = make_button("Camera", "Focus, exposure and calibration", "K");
  region_ = make_button("Search region", kRegionTip, "G");
  row->addWidget(region_);
  row->addWidget(camera_);
  row->addWidget(thresholds_);
  row->addWidget(why_);
  connect(thresholds_, &QPushButton::clicked, this, &ConsoleWidget::begin_thresholds);
  connect(why_, &QPushButton::clicked, this, &ConsoleWidget::ask_for_place);
  connect(marks_, &QPushButton::toggled, [this](bool hidden) { image_->show_marks(!hidden); });
  connect(fit_, &QPushButton::clicked, image_, &ImageView::show_all);
  return bar;
}

QShortcut* ConsoleWidget::on_key(const QKeySequence& keys, QWidget* where,
                                 const std::function<void()>& act) {
  auto* shortcut = new QShortcut(keys, where);
  shortcut->setContext(Qt::WidgetWithChildrenShortcut);
  connect(shortcut, &QShortcut::activated, this, act);
  return shortcut;
}

// Letter keys act only while the image has the focus, so that names can be typed.
void ConsoleWidget::make_shortcuts() {
  const struct {
    int key;
    Tool tool;
  } tools[] = {{Qt::Key_A, Tool::kInclude},
               {Qt::Key_C, Tool::kExclude},
               {Qt::Key_R, Tool::kRegion},
               {Qt::Key_X, Tool::kAxes}};
  for (const auto& entry : tools)
    on_key(entry.key, this, [this, tool = entry.tool] { take_tool(tool); });
  on_key(Qt::Key_Escape, this, [this] { escape(); });
  on_key(QKeySequence::Undo, this, [this] { send_word(Confirm::UNDO); });
  for (const int key : {Qt::Key_Return, Qt::Key_Enter})
    on_key(Qt::CTRL + key, this, [this] { send_word(Confirm::ACCEPT); });
  on_key(Qt::CTRL + Qt::Key_N, this, [this] { lesson_bar_->take_keyboard(); });
  on_key(Qt::Key_W, this, [this] { ask_for_place(); });
  on_key(Qt::Key_K, this, [this] { camera_->click(); });
  on_key(Qt::Key_G, this, [this] { region_->click(); });
  on_key(Qt::Key_S, this, [this] { begin_thresholds(); });
  on_key(Qt::Key_H, this, [this] { marks_->toggle(); });
  for (const int key : {Qt::Key_Plus, Qt::Key_Equal})
    on_key(key, this, [this] { image_->enlarge(kStep); });
  on_key(Qt::Key_Minus, this, [this] { image_->enlarge(1 / kStep); });
  on_key(Qt::Key_0, this, [this] { image_->show_all(); });
  space_ = on_key(Qt::Key_Space, image_, [this] { next_view(); });
  space_->setEnabled(false);
}

void ConsoleWidget::take_tool(Tool tool) {
  if (!lesson_.draft()) return;
  review_->choose_tool(tool);
  image_->setFocus();
}

void ConsoleWidget::connect_lesson() {
  connect(&ros_, &RosLink::status_heard, this, [this](const auto& status) {
    const bool was_gone = lesson_.phase() == LessonModel::Phase::kNoServer;
    lesson_.take_status(status, now());
    // A restarted nodelet may have other objects in its library.
    if (was_gone) {
      ros_.list_objects();
      const std::string lacking = ros_.why_no_grasps();
      lesson_bar_->allow_marks(lacking.empty(), QString::fromStdString(lacking));
    }
    show_lesson();
  });
  connect(&ros_, &RosLink::feedback_heard, this, [this](const auto& feedback) {
    lesson_.take_feedback(feedback, now());
    send_next();
    show_lesson();
  });
  connect(&ros_, &RosLink::lesson_image_heard, this,
          [this](const QImage& image) { lesson_image_ = image; });
  connect(&ros_, &RosLink::draft_heard, this, [this](const auto& draft) {
    lesson_.take_draft(draft);
    show_lesson();
  });
  connect(&ros_, &RosLink::result_heard, this, &ConsoleWidget::end_lesson);
  connect(&ros_, &RosLink::confirmed, this,
          [this](bool answered, bool success, const QString& message) {
            if (answered)
              lesson_.take_answer(success, message.toStdString());
            else
              lesson_.take_no_answer(message.toStdString());
            send_next();
            show_lesson();
          });
  connect(&ros_, &RosLink::grasp_marked, this,
          [this](bool success, const QString& message) { tell(success, "Grasp: " + message); });
  connect(&ros_, &RosLink::score_map_heard, review_, &ReviewPane::show_score_map);
}

void ConsoleWidget::connect_operator() {
  connect(lesson_bar_, &LessonBar::teach_wanted, this, &ConsoleWidget::want_lesson);
  connect(lesson_bar_, &LessonBar::cancel_wanted, this, [this] { ros_.cancel(lesson_.goal()); });
  connect(lesson_bar_, &LessonBar::mark_wanted, this, [this] { ros_.mark_grasp(); });
  connect(lesson_bar_, &LessonBar::name_edited, this, &ConsoleWidget::withdraw_question);
  connect(image_, &ImageView::corrected, this, &ConsoleWidget::send);
  connect(review_, &ReviewPane::decided, this, &ConsoleWidget::send_word);
  connect(review_, &ReviewPane::insisted, this, [this](bool insisted) {
    lesson_.insist(insisted);
    show_lesson();
  });
  connect(review_, &ReviewPane::tool_chosen, this, [this](int tool) {
    image_->tool().choose(static_cast<Tool>(tool));
    image_->update();
  });
  connect(review_, &ReviewPane::stroke_width_chosen, this,
          [this](int width) { image_->tool().set_stroke_width(width); });
}

void ConsoleWidget::connect_library() {
  connect(&ros_, &RosLink::objects_listed, this, [this](const auto& objects, const auto&) {
    const auto enabled = std::count_if(objects.begin(), objects.end(),
                                       [](const auto& object) { return object.enabled; });
    lamps_.take_library(objects.size(), static_cast<std::size_t>(enabled));
    if (lesson_.take_library(objects)) withdraw_question();
    show_lesson();
  });
  connect(library_, &LibraryController::told, this, &ConsoleWidget::tell);
  connect(library_, &LibraryController::edited, this, [this] { lesson_bar_->clear_notice(); });
  connect(library_, &LibraryController::name_gone, this, &ConsoleWidget::withdraw_question);
  connect(strip_, &LibraryStrip::view_wanted, this, [this](const QString& name) {
    begin({What::kView, name.toStdString()});
  });
}

void ConsoleWidget::connect_cell() {
  connect(&ros_, &RosLink::detections_heard, this, [this](const auto& detections, double age) {
    detections_at_ = now();
    lamps_.take_detections(detections, now());
    detections_age_ = age;
    detections_->show_detections(detections, age);
  });
  connect(&ros_, &RosLink::diagnostics_heard, this,
          [this](const auto& diagnostics) { lamps_.take_diagnostics(diagnostics, now()); });
  connect(&ros_, &RosLink::origin_heard, this, [this](const QString& warning) {
    origin_warning_ = warning;
    lamps_.take_origin(warning.toStdString());
  });
  connect(&ros_, &RosLink::image_heard, this, [this](const QImage& image, QSize size) {
    image_at_ = now();
    lamps_.take_image(now());
    show_live(image, size, nullptr);
  });
  connect(&ros_, &RosLink::searched_heard, this,
          [this](const QImage& image, QSize size, const auto& detections) {
            show_live(image, size, &detections);
          });
}

void ConsoleWidget::tell(bool success, const QString& sentence) {
  lesson_bar_->say({success ? Level::kGood : Level::kBad, sentence.toStdString()}, now());
}

void ConsoleWidget::want_lesson() {
  if (!lesson_.may_teach()) return;
  const std::string name = lesson_bar_->goal().name;
  if (library_->library().find(name) != nullptr) return ask_about_name(name);
  begin({What::kNew, name});
}

void ConsoleWidget::ask_about_name(const std::string& name) {
  lesson_bar_->clear_notice();
  const std::string other = free_name(name, library_->library().names());
  lesson_bar_->ask(
      "The name is taken",
      {Level::kUnknown, "'" + name +
                            "' is in the library already. Replace it, add a view to "
                            "it, or teach this one under the new name '" +
                            other + "'?"},
      {{"Re&place it", "Teach it again; Undo edit restores the old one",
        [this, name] {
          begin({What::kReplace, name});
        }},
       {"&Add view", "Teach this side also in different light or slightly rotated",
        [this, name] {
          begin({What::kView, name});
        }},
       {"Ne&w name", "Teach it as another object, '" + QString::fromStdString(other) + "'",
        [this, other] {
          lesson_bar_->set_name(other);
          begin({What::kNew, other});
        }}});
  lesson_bar_->give_keyboard_to_answers();
}

void ConsoleWidget::begin(const TeachingWish& wish) {
  if (!lesson_.may_teach()) return;
  wish_ = wish;
  viewed_ = wish.what == What::kView ? wish.name : "";
  lesson_bar_->clear_notice();
  lesson_bar_->withdraw_question();
  lesson_.begin(ros_.teach(goal_of(wish, lesson_bar_->goal())), now());
  image_->setFocus();
  show_lesson();
}

void ConsoleWidget::end_lesson(const mbncc_vision::LearnObjectActionResult& result) {
  const bool own = result.status.goal_id.id == lesson_.goal();
  lesson_.take_result(result, now());
  show_lesson();
  if (!own) return;
  const Result outcome = outcome_of(result);
  if (outcome.error_code == Result::NAME_TAKEN) return ask_about_name(wish_.name);
  if (outcome.error_code == Result::SUCCESS) {
    if (wish_.what != What::kNew) library_->retaught(outcome.object.name);
    strip_->choose(QString::fromStdString(outcome.object.name));
    lesson_bar_->clear_name();
    return offer_next_view(outcome.object.name);
  }
  if (!viewed_.empty()) offer_next_view(viewed_);
}

/// Space starts the next view only while views of an object are being taught.
void ConsoleWidget::offer_next_view(const std::string& name) {
  const bool goes_on = !viewed_.empty();
  const std::string question =
      goes_on ? " Rotate '" + name + "' slightly or change the light, then press Space."
              : " Should it also be found in different light?";
  lesson_bar_->ask(
      "", {lesson_.level(), lesson_.detail() + question},
      {{goes_on ? "Ne&xt view (Space)" : "Teach anothe&r view",
        "Lay the object down in another position before you press this",
        [this, name] {
          begin({What::kView, name});
        }},
       {goes_on ? "Done" : "No", "Finish teaching views (Esc)", [this] { viewed_.clear(); }}});
}

void ConsoleWidget::withdraw_question() {
  viewed_.clear();
  lesson_bar_->withdraw_question();
}

void ConsoleWidget::next_view() {
  if (!viewed_.empty()) begin({What::kView, viewed_});
}

void ConsoleWidget::send(const Confirm& request) {
  lesson_bar_->clear_notice();
  lesson_.want(request);
  send_next();
  show_lesson();
}

void ConsoleWidget::send_word(int command) {
  if (command == Confirm::ACCEPT && !lesson_.may_accept()) return;
  if (command == Confirm::UNDO && !lesson_.may_undo()) return;
  // Move the focus first: the button is about to be disabled, and Qt would pass the focus to the
  // next widget.
  if (command != Confirm::UNDO) image_->setFocus();
  Confirm request;
  request.command = static_cast<std::uint8_t>(command);
  send(request);
}

void ConsoleWidget::send_next() {
  if (const auto word = lesson_.next_word()) ros_.confirm(*word);
}

void ConsoleWidget::connect_explanation() {
  connect(image_, &ImageView::place_chosen, this, [this](QPointF place) {
    lesson_bar_->clear_notice();
    explanation_->ask();
    explained_caption_ = still_caption();
    side_->setCurrentWidget(explanation_);
    ros_.explain(place);
  });
  connect(&ros_, &RosLink::explained, this, &ConsoleWidget::show_explanation);
  connect(&ros_, &RosLink::explained_saved, explanation_, &ExplainPane::show_saved);
  connect(explanation_, &ExplainPane::save_wanted, this, [this] { ros_.save_explained(); });
  connect(threshold_controller_, &ThresholdController::told, this, &ConsoleWidget::tell);
  connect(threshold_controller_, &ThresholdController::applied, this,
          &ConsoleWidget::end_explanation);
  connect(threshold_controller_, &ThresholdController::found, this, [this] {
    if (!lesson_.may_teach()) return;
    side_->setCurrentWidget(threshold_pane_);
    threshold_controller_->begin(strip_->chosen(), library_->library());
  });
  connect(threshold_controller_, &ThresholdController::own_wanted, library_,
          &LibraryController::set_threshold);
  connect(threshold_pane_, &ThresholdPane::closed, this, &ConsoleWidget::end_explanation);
  connect(explanation_, &ExplainPane::closed, this, &ConsoleWidget::end_explanation);
}

void ConsoleWidget::connect_calibration() {
  connect(camera_, &QPushButton::clicked, this, [this] {
    calibration_->begin();
    side_->setCurrentWidget(calibration_);
  });
  connect(calibration_, &CalibrationPane::closed, this, &ConsoleWidget::end_explanation);
  connect(calibration_, &CalibrationPane::keep_wanted, this,
          [this](const auto& calibration) { ros_.keep_calibration(calibration); });
  connect(calibration_, &CalibrationPane::platform_wanted, this,
          [this] { calibration_->calibrate_platform(ros_.images()); });
  connect(&ros_, &RosLink::calibration_kept, calibration_, &CalibrationPane::show_kept);
  connect(&ros_, &RosLink::image_heard, this, [this](const QImage& image, QSize size) {
    if (side_->currentWidget() != calibration_) return;
    image_->show_image(image, size, calibration_->take(image, size), live_caption(false));
  });
}

void ConsoleWidget::connect_region() {
  connect(region_, &QPushButton::clicked, this, &ConsoleWidget::ask_for_region);
  connect(image_, &ImageView::region_chosen, this, [this](const QRect& region) {
    lesson_bar_->clear_notice();
    ros_.set_search_region(region);
  });
  connect(&ros_, &RosLink::search_region_heard, this, &ConsoleWidget::show_region);
  connect(&ros_, &RosLink::search_region_set, this, &ConsoleWidget::tell);
}

/// The same button sets the region and clears it.
void ConsoleWidget::ask_for_region() {
  if (!lesson_.may_teach()) return;
  end_explanation();
  if (!searched_.isEmpty()) return ros_.set_search_region({});
  image_->ask_for_place(false);
  image_->ask_for_region(true);
  image_->setFocus();
  lesson_bar_->say({Level::kUnknown,
                    "Draw a box around all places where objects are to be found, by the mouse, or "
                    "by arrow keys and Space at two corners; Esc cancels."},
                   now());
}

void ConsoleWidget::show_region(const QRect& region) {
  searched_ = region;
  relabel(region_, region.isEmpty() ? "Search region" : "Search everywhere");
  region_->setToolTip(QString(region.isEmpty() ? kRegionTip : "Search the whole image again") +
                      " (G)");
  show_lesson();
}

bool ConsoleWidget::explains() const {
  return side_->currentWidget() == explanation_ || side_->currentWidget() == calibration_ ||
         side_->currentWidget() == threshold_pane_;
}

void ConsoleWidget::ask_for_place() {
  if (!lesson_.may_teach()) return;
  end_explanation();
  image_->ask_for_region(false);
  image_->ask_for_place(true);
  image_->setFocus();
  lesson_bar_->say(
      {Level::kUnknown,
       "Click the middle of the object that should be found, or move there with the arrow keys "
       "and press Space; Esc cancels."},
      now());
  show_lesson();
}

void ConsoleWidget::show_explanation(bool success, const QString& lines, const QImage& image) {
  if (!explains()) return;
  explanation_->show_answer(success, lines);
  if (!image.isNull()) image_->show_image(image, image.size(), {}, explained_caption_);
}

void ConsoleWidget::end_explanation() {
  if (!explains()) return;
  image_->setFocus();
  side_->setCurrentWidget(cell_page_);
}

void ConsoleWidget::begin_thresholds() {
  if (!lesson_.may_teach()) return;
  lesson_bar_->clear_notice();
  threshold_controller_->ask();
}

/// Cancels one thing per key press: an unfinished stroke first, then the tool, then a question.
void ConsoleWidget::escape() {
  if (explains())
    end_explanation();
  else if (image_->asks_for_place())
    image_->ask_for_place(false);
  else if (image_->asks_for_region())
    image_->ask_for_region(false);
  else if (lesson_.draft() && !image_->give_up())
    review_->choose_tool(Tool::kNone);
  else if (!lesson_.draft())
    withdraw_question();
  image_->setFocus();
}

void ConsoleWidget::look_at_clock() {
  const auto before = lesson_.phase();
  lesson_.look_at_clock(now());
  lesson_.take_camera(now() - image_at_ <= Lamps::kSilence);
  // A call that waits for a hung server must not delay calls to its successor.
  if (lesson_.phase() == LessonModel::Phase::kNoServer && lesson_.phase() != before) {
    ros_.give_up();
    lamps_.forget_library();
    lesson_bar_->withdraw_question();
  }
  lamp_row_->show_lamps(lamps_.look(now()));
  if (now() - detections_at_ > Lamps::kSilence) detections_->clear_rows();
  warn_of_old_image();
  show_lesson();
}

/// An outdated image must not be mistaken for a live one.
void ConsoleWidget::warn_of_old_image() {
  const bool calibrates = side_->currentWidget() == calibration_;
  if (lesson_.draft() || (explains() && !calibrates)) return;
  const double age = calibrates ? now() - image_at_ : live_.age(now());
  if (age > Lamps::kSilence)
    image_->show_age(QString("OLD IMAGE: nothing has arrived for %1 s").arg(static_cast<int>(age)));
}

void ConsoleWidget::show_lesson() {
  lesson_bar_->show_lesson(lesson_, now());
  review_->show_lesson(lesson_);
  strip_->setEnabled(lesson_.phase() != LessonModel::Phase::kNoServer);
  strip_->allow_teaching(lesson_.may_teach());
  for (auto* button : {why_, thresholds_, region_}) button->setEnabled(lesson_.may_teach());
  if (!lesson_.may_teach() && image_->asks_for_region()) image_->ask_for_region(false);
  // A camera can be calibrated before the rest of the cell is running.
  const bool idle = lesson_.may_teach() || lesson_.phase() == LessonModel::Phase::kNoServer;
  camera_->setEnabled(idle);
  if (!idle) end_explanation();
  image_->show_waiting(lesson_.waiting());
  ros_.show_changes(lesson_.waits_for_scene());
  const bool searches = !lesson_.draft() && side_->currentWidget() != calibration_;
  image_->show_region(searches ? searched_ : QRect());
  space_->setEnabled(!viewed_.empty() && lesson_.may_teach() && !image_->asks_for_place());
  if (lesson_.draft_number() == draft_shown_) return;
  draft_shown_ = lesson_.draft_number();
  const bool asked = lesson_.draft().has_value();
  if (asked && side_->currentWidget() != review_) image_->setFocus();
  if (asked)
    side_->setCurrentWidget(review_);
  else if (side_->currentWidget() == review_)
    end_review();
  if (asked) show_draft();
}

/// The focus must not move to the widget after the button that was hidden.
void ConsoleWidget::end_review() {
  if (review_->isAncestorOf(focusWidget())) image_->setFocus();
  side_->setCurrentWidget(cell_page_);
}

void ConsoleWidget::show_draft() {
  const auto& draft = *lesson_.draft();
  const QImage preview = to_qimage(to_rgb(draft.preview));
  image_->tool().set_axes(draft.object.reference, axes_length(preview.size()));
  if (lesson_image_.size() == preview.size())
    image_->show_image(lesson_image_, preview.size(), marks_of(draft), kLessonCaption);
  else
    image_->show_image(preview, preview.size(), {}, kLessonCaption);
}

QString ConsoleWidget::live_caption(bool searched) const {
  if (!origin_warning_.isEmpty()) return origin_warning_;
  if (lesson_.waits_for_scene()) return "Live, changes tinted orange";
  return searched ? QString("Live, %1 s old").arg(detections_age_, 0, 'f', 1) : "Live";
}

void ConsoleWidget::show_live(const QImage& image, QSize size,
                              const mbncc_vision::DetectedObjectArray* detections) {
  if (lesson_.draft() || explains()) return;
  const bool teaching = lesson_.phase() == LessonModel::Phase::kRunning;
  if (!live_.take(detections != nullptr, teaching, now())) return;
  image_->show_image(image, size, detections ? marks_of(*detections) : std::vector<Mark>{},
                     live_caption(detections != nullptr));
}

}  // namespace mbncc::console
