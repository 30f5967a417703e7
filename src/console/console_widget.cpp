// SPDX-License-Identifier: BSD-3-Clause
#include "console/console_widget.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "console/calibration/calibration_pane.hpp"
#include "console/detections/detections_view.hpp"
#include "console/detections/lamp_row.hpp"
#include "console/explain/explain_pane.hpp"
#include "console/image/image_bar.hpp"
#include "console/image/image_view.hpp"
#include "console/lesson/lesson_bar.hpp"
#include "console/lesson/lesson_controller.hpp"
#include "console/lesson/review_pane.hpp"
#include "console/library/library_controller.hpp"
#include "console/library/library_strip.hpp"
#include "console/thresholds/threshold_controller.hpp"
#include "console/thresholds/threshold_pane.hpp"

namespace mbncc::console {
namespace {

using Confirm = mbncc_vision::ConfirmLearning::Request;

constexpr int kTick = 200;       // [ms]
constexpr int kSideWidth = 400;  // [px] at least
constexpr double kStep = 1.25;   // zoom factor per key press

}  // namespace

ConsoleWidget::ConsoleWidget(const Names& names, QWidget* parent)
    : QWidget(parent),
      lamp_row_(new LampRow),
      lesson_bar_(new LessonBar),
      image_(new ImageView),
      image_bar_(new ImageBar),
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
  lesson_ = new LessonController(clock_, ros_, {*lesson_bar_, *review_, *image_, *strip_},
                                 *library_, this);
  lay_out();
  make_shortcuts();
  connect_lesson();
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
  left->addWidget(image_bar_);
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
    on_key(entry.key, this, [this, tool = entry.tool] { lesson_->choose_tool(tool); });
  on_key(Qt::Key_Escape, this, [this] { escape(); });
  on_key(QKeySequence::Undo, this, [this] { lesson_->send_word(Confirm::UNDO); });
  for (const int key : {Qt::Key_Return, Qt::Key_Enter})
    on_key(Qt::CTRL + key, this, [this] { lesson_->send_word(Confirm::ACCEPT); });
  on_key(Qt::CTRL + Qt::Key_N, this, [this] { lesson_bar_->take_keyboard(); });
  on_key(Qt::Key_W, this, [this] { ask_for_place(); });
  on_key(Qt::Key_K, this, [this] { image_bar_->press_camera(); });
  on_key(Qt::Key_G, this, [this] { image_bar_->press_region(); });
  on_key(Qt::Key_S, this, [this] { begin_thresholds(); });
  on_key(Qt::Key_H, this, [this] { image_bar_->press_marks(); });
  for (const int key : {Qt::Key_Plus, Qt::Key_Equal})
    on_key(key, this, [this] { image_->enlarge(kStep); });
  on_key(Qt::Key_Minus, this, [this] { image_->enlarge(1 / kStep); });
  on_key(Qt::Key_0, this, [this] { image_->show_all(); });
  space_ = on_key(Qt::Key_Space, image_, [this] { lesson_->next_view(); });
  space_->setEnabled(false);
}

void ConsoleWidget::connect_lesson() {
  connect(lesson_, &LessonController::changed, this, &ConsoleWidget::show_lesson);
  connect(lesson_, &LessonController::draft_changed, this, &ConsoleWidget::show_review);
  connect(lesson_, &LessonController::server_came, this, [this] {
    ros_.list_objects();
    const std::string lacking = ros_.why_no_grasps();
    lesson_bar_->allow_marks(lacking.empty(), QString::fromStdString(lacking));
  });
  connect(lesson_, &LessonController::server_gone, this, [this] {
    lamps_.forget_library();
    library_->forget_folder();
  });
  connect(lesson_bar_, &LessonBar::mark_wanted, this, [this] { ros_.mark_grasp(); });
  connect(&ros_, &RosLink::grasp_marked, this,
          [this](bool success, const QString& message) { tell(success, "Grasp: " + message); });
}

void ConsoleWidget::connect_library() {
  connect(&ros_, &RosLink::objects_listed, this, [this](const auto& objects, const auto&) {
    const auto enabled = std::count_if(objects.begin(), objects.end(),
                                       [](const auto& object) { return object.enabled; });
    lamps_.take_library(objects.size(), static_cast<std::size_t>(enabled));
  });
  connect(library_, &LibraryController::told, this, &ConsoleWidget::tell);
  connect(library_, &LibraryController::edited, this, [this] { lesson_bar_->clear_notice(); });
}

void ConsoleWidget::connect_cell() {
  connect(image_bar_, &ImageBar::marks_hidden, this,
          [this](bool hidden) { image_->show_marks(!hidden); });
  connect(image_bar_, &ImageBar::all_wanted, image_, &ImageView::show_all);
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

void ConsoleWidget::connect_explanation() {
  connect(image_bar_, &ImageBar::explanation_wanted, this, &ConsoleWidget::ask_for_place);
  connect(image_bar_, &ImageBar::thresholds_wanted, this, &ConsoleWidget::begin_thresholds);
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
    if (!lesson_->lesson().may_teach()) return;
    side_->setCurrentWidget(threshold_pane_);
    threshold_controller_->begin(strip_->chosen(), library_->library());
  });
  connect(threshold_controller_, &ThresholdController::own_wanted, library_,
          &LibraryController::set_threshold);
  connect(threshold_pane_, &ThresholdPane::closed, this, &ConsoleWidget::end_explanation);
  connect(explanation_, &ExplainPane::closed, this, &ConsoleWidget::end_explanation);
}

void ConsoleWidget::connect_calibration() {
  connect(image_bar_, &ImageBar::camera_wanted, this, [this] {
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
  connect(image_bar_, &ImageBar::region_wanted, this, &ConsoleWidget::ask_for_region);
  connect(image_, &ImageView::region_chosen, this, [this](const QRect& region) {
    lesson_bar_->clear_notice();
    ros_.set_search_region(region);
  });
  connect(&ros_, &RosLink::search_region_heard, this, &ConsoleWidget::show_region);
  connect(&ros_, &RosLink::search_region_set, this, &ConsoleWidget::tell);
}

/// The same button sets the region and clears it.
void ConsoleWidget::ask_for_region() {
  if (!lesson_->lesson().may_teach()) return;
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
  image_bar_->show_region(!region.isEmpty());
  show_lesson();
}

bool ConsoleWidget::explains() const {
  return side_->currentWidget() == explanation_ || side_->currentWidget() == calibration_ ||
         side_->currentWidget() == threshold_pane_;
}

void ConsoleWidget::ask_for_place() {
  if (!lesson_->lesson().may_teach()) return;
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
  if (!lesson_->lesson().may_teach()) return;
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
  else if (lesson_->lesson().draft() && !image_->give_up())
    review_->choose_tool(Tool::kNone);
  else if (!lesson_->lesson().draft())
    lesson_->withdraw_question();
  image_->setFocus();
}

void ConsoleWidget::look_at_clock() {
  lesson_->look_at_clock(now() - image_at_ <= Lamps::kSilence);
  lamp_row_->show_lamps(lamps_.look(now()));
  if (now() - detections_at_ > Lamps::kSilence) detections_->clear_rows();
  warn_of_old_image();
}

/// An outdated image must not be mistaken for a live one.
void ConsoleWidget::warn_of_old_image() {
  const bool calibrates = side_->currentWidget() == calibration_;
  if (lesson_->lesson().draft() || (explains() && !calibrates)) return;
  const double age = calibrates ? now() - image_at_ : live_.age(now());
  if (age > Lamps::kSilence)
    image_->show_age(QString("OLD IMAGE: nothing has arrived for %1 s").arg(static_cast<int>(age)));
}

void ConsoleWidget::show_lesson() {
  const LessonModel& lesson = lesson_->lesson();
  const bool no_server = lesson.phase() == LessonModel::Phase::kNoServer;
  strip_->setEnabled(!no_server);
  strip_->allow_teaching(lesson.may_teach());
  if (!lesson.may_teach() && image_->asks_for_region()) image_->ask_for_region(false);
  // A camera can be calibrated before the rest of the cell is running.
  const bool idle = lesson.may_teach() || no_server;
  image_bar_->allow(lesson.may_teach(), idle);
  if (!idle) end_explanation();
  const bool searches = !lesson.draft() && side_->currentWidget() != calibration_;
  image_->show_region(searches ? searched_ : QRect());
  space_->setEnabled(lesson_->offers_view() && !image_->asks_for_place());
}

void ConsoleWidget::show_review() {
  const bool asked = lesson_->lesson().draft().has_value();
  if (asked == (side_->currentWidget() == review_)) return;
  // The focus must not move to the widget after a button that is hidden.
  if (asked || review_->isAncestorOf(focusWidget())) image_->setFocus();
  side_->setCurrentWidget(asked ? review_ : cell_page_);
}

QString ConsoleWidget::live_caption(bool searched) const {
  if (!origin_warning_.isEmpty()) return origin_warning_;
  if (lesson_->lesson().waits_for_scene()) return "Live, changes tinted orange";
  return searched ? QString("Live, %1 s old").arg(detections_age_, 0, 'f', 1) : "Live";
}

void ConsoleWidget::show_live(const QImage& image, QSize size,
                              const mbncc_vision::DetectedObjectArray* detections) {
  if (lesson_->lesson().draft() || explains()) return;
  const bool teaching = lesson_->lesson().phase() == LessonModel::Phase::kRunning;
  if (!live_.take(detections != nullptr, teaching, now())) return;
  image_->show_image(image, size, detections ? marks_of(*detections) : std::vector<Mark>{},
                     live_caption(detections != nullptr));
}

}  // namespace mbncc::console
