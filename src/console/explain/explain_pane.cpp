// SPDX-License-Identifier: BSD-3-Clause
#include "console/explain/explain_pane.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "console/widgets.hpp"

namespace mbncc::console {

ExplainPane::ExplainPane(QWidget* parent)
    : QWidget(parent),
      verdict_(new QLabel),
      lines_(new QLabel),
      saved_(new QLabel),
      save_(make_button("Sa&ve this miss", "Image, library, settings and reason in one file",
                        "Alt+V")),
      close_(make_button("&Back to live", "Show the camera's images again", "Esc")) {
  QFont bold = verdict_->font();
  bold.setBold(true);
  verdict_->setFont(bold);
  for (auto* text : {verdict_, lines_, saved_}) {
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  lines_->setAlignment(Qt::AlignTop);
  auto* area = make_scroll_area(lines_);
  area->setObjectName("explanation");
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* row = new QHBoxLayout;
  row->addWidget(save_);
  row->addWidget(close_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(verdict_);
  all->addWidget(area, 1);
  all->addWidget(saved_);
  all->addLayout(row);
  connect(save_, &QPushButton::clicked, this, &ExplainPane::save_wanted);
  connect(close_, &QPushButton::clicked, this, &ExplainPane::closed);
}

void ExplainPane::ask() {
  verdict_->setText("Searching for the reason ...");
  lines_->clear();
  saved_->clear();
  save_->setEnabled(false);
}

void ExplainPane::show_answer(bool answered, const QString& lines) {
  const int end = lines.indexOf('\n');
  verdict_->setText(answered ? lines.left(end) : "No explanation: " + lines);
  lines_->setText(answered && end >= 0 ? lines.mid(end + 1).replace("\n", "\n\n") : "");
  save_->setEnabled(answered);
}

void ExplainPane::show_saved(const QString& file) {
  saved_->setText(file.isEmpty()
                      ? "The file could not be saved."
                      : "Saved on the cell's computer: " + file + "\nmbncc replay repeats it.");
}

}  // namespace mbncc::console
