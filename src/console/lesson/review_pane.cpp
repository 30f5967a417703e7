// SPDX-License-Identifier: BSD-3-Clause
#include "console/lesson/review_pane.hpp"

#include <mbncc_vision/ConfirmLearning.h>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "console/image/images.hpp"
#include "console/image/scaled_image.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

using Request = mbncc_vision::ConfirmLearning::Request;

constexpr QSize kTemplate(130, 130), kScoreMap(380, 130);  // at least

QString reasons_of(const mbncc_vision::LearnQuality& quality) {
  if (quality.advice.empty()) return "No complaints.";
  QString text;
  for (const auto& advice : quality.advice)
    text += QString::fromUtf8("\u2022 ") + QString::fromStdString(advice) + "\n";
  return text.trimmed();
}

QString numbers_of(const mbncc_vision::LearnQuality& quality) {
  return QString("Finds itself: %1\nNext best place: %2\nOn edges: %3 %\nArea: %4 px\u00b2")
      .arg(quality.self_score, 0, 'f', 2)
      .arg(quality.runner_up, 0, 'f', 2)
      .arg(100 * quality.edge_agreement, 0, 'f', 0)
      .arg(static_cast<int>(quality.area));
}

}  // namespace

ReviewPane::ReviewPane(QWidget* parent)
    : QWidget(parent),
      verdict_(new QLabel),
      numbers_(new QLabel),
      reasons_(new QLabel),
      template_(new ScaledImage(kTemplate)),
      score_map_(new ScaledImage(kScoreMap)),
      insist_(new QCheckBox("I have checked it; store it despite BAD")),
      accept_(make_button("&Accept", "Store the object", "Alt+A or Ctrl+Enter")),
      reject_(make_button("&Reject", "End the lesson; nothing is stored", "Alt+R")),
      undo_(make_button("&Undo mark", "Undo the last correction", "Ctrl+Z")),
      tools_(new QButtonGroup(this)),
      width_(new QSlider(Qt::Horizontal)) {
  template_->setToolTip("What was learned; the checkerboard is not part of it");
  score_map_->setToolTip(
      "Where the image resembles the object at a first look (yellow: much):\nring = the object, "
      "square = the next best place. The scores above judge all.");
  QFont large = verdict_->font();
  large.setPointSize(15);
  verdict_->setFont(large);
  for (auto* text : {numbers_, reasons_}) text->setWordWrap(true);
  reasons_->setAlignment(Qt::AlignTop);
  QFont bold = accept_->font();
  bold.setBold(true);
  for (auto* button : {accept_, reject_}) {
    button->setFont(bold);
    button->setMinimumHeight(34);
  }
  QSizePolicy keeps_its_place = insist_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);
  insist_->setSizePolicy(keeps_its_place);
  lay_out();

  name_window(insist_, "insist");
  connect(insist_, &QCheckBox::clicked, this, &ReviewPane::insisted);
  connect(accept_, &QPushButton::clicked, [this] { Q_EMIT decided(Request::ACCEPT); });
  connect(reject_, &QPushButton::clicked, [this] { Q_EMIT decided(Request::REJECT); });
  connect(undo_, &QPushButton::clicked, [this] { Q_EMIT decided(Request::UNDO); });
}

void ReviewPane::lay_out() {
  auto* images = new QHBoxLayout;
  images->addWidget(template_, 1);
  images->addWidget(numbers_, 1);
  auto* word = new QHBoxLayout;
  word->addWidget(accept_);
  word->addWidget(reject_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(verdict_);
  all->addLayout(images, 1);
  all->addWidget(score_map_, 1);
  auto* advice = make_scroll_area(reasons_);
  advice->setObjectName("advice");
  advice->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  all->addWidget(advice, 1);
  all->addWidget(make_tools());
  all->addWidget(insist_);
  all->addLayout(word);
}

QWidget* ReviewPane::make_tools() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  const struct {
    Tool tool;
    const char *text, *tip, *key;
  } tools[] = {
      {Tool::kInclude, "Add", "Draw over missing parts of the object", "A; Esc deselects it"},
      {Tool::kExclude, "Cut", "Draw over parts that do not belong to the object",
       "C; Esc deselects it"},
      {Tool::kRegion, "Region", "Draw a box around the object", "R; Esc deselects it"},
      {Tool::kAxes, "Axes", "Drag the origin; drag the round tip to rotate", "X; Esc deselects it"},
  };
  int column = 0;
  for (const auto& entry : tools) {
    auto* button = make_button(entry.text, entry.tip, entry.key);
    button->setCheckable(true);
    tools_->addButton(button, static_cast<int>(entry.tool));
    connect(button, &QPushButton::clicked, [this, tool = entry.tool] { choose_tool(tool); });
    grid->setColumnStretch(column, 1);
    grid->addWidget(button, 0, column++);
  }
  width_->setRange(2, 40);
  width_->setValue(8);
  name_window(width_, "stroke width");
  width_->setToolTip("Width of the stroke in pixels");
  grid->addWidget(new QLabel("Stroke"), 1, 0);
  grid->addWidget(width_, 1, 1);
  grid->addWidget(undo_, 1, 2, 1, 2);
  connect(width_, &QSlider::valueChanged, this, &ReviewPane::stroke_width_chosen);
  return box;
}

void ReviewPane::show_lesson(const LessonModel& lesson) {
  accept_->setEnabled(lesson.may_accept());
  reject_->setEnabled(lesson.may_decide());
  undo_->setEnabled(lesson.may_undo());
  for (auto* button : tools_->buttons()) button->setEnabled(lesson.may_correct());
  width_->setEnabled(lesson.may_correct());
  insist_->setVisible(lesson.must_insist());
  insist_->setEnabled(lesson.may_decide());
  insist_->setChecked(lesson.may_accept());
  const bool asked = lesson.draft().has_value();
  if (asked && lesson.draft_number() != draft_shown_) show_draft(*lesson.draft());
  draft_shown_ = lesson.draft_number();
  if (!asked) put_tool_down();
}

void ReviewPane::choose_tool(Tool tool) {
  if (auto* button = tools_->button(static_cast<int>(tool))) {
    if (!button->isEnabled()) return;
    button->setChecked(true);
  } else if (auto* held = tools_->checkedButton()) {
    tools_->setExclusive(false);
    held->setChecked(false);
    tools_->setExclusive(true);
  }
  Q_EMIT tool_chosen(static_cast<int>(tool));
}

void ReviewPane::put_tool_down() {
  if (tools_->checkedButton()) choose_tool(Tool::kNone);
}

void ReviewPane::show_draft(const mbncc_vision::LearnObjectResult& draft) {
  const auto& quality = draft.object.quality;
  show_level(verdict_, level_of_verdict(quality.verdict),
             QString::fromStdString(word_of_verdict(quality.verdict)));
  numbers_->setText(numbers_of(quality));
  reasons_->setText(reasons_of(quality));
  template_->show_image(to_qimage(on_checkerboard(to_rgb(draft.template_image), draft.map)));
}

void ReviewPane::show_score_map(const QImage& map) {
  score_map_->show_image(map);
}

}  // namespace mbncc::console
