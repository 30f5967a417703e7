// SPDX-License-Identifier: BSD-3-Clause
#include "console/teach_panel.hpp"

#include <QTimer>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include "console/widgets.hpp"

namespace mbncc::console {

TeachPanel::TeachPanel(QWidget* parent) : rviz::Panel(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
}

void TeachPanel::onInitialize() {
  // Deferred, because RViz loads the configuration, which holds the names, after the constructor.
  QTimer::singleShot(0, this, [this] { begin(); });
}

void TeachPanel::begin() {
  delete console_;
  console_ = make_scroll_area(new ConsoleWidget(names_));
  console_->setFocusPolicy(Qt::NoFocus);
  layout()->addWidget(console_);
}

void TeachPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString("Cell namespace", &text)) names_.cell = text.toStdString();
  if (config.mapGetString("Matching nodelet", &text)) names_.matching = text.toStdString();
}

void TeachPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Cell namespace", QString::fromStdString(names_.cell));
  config.mapSetValue("Matching nodelet", QString::fromStdString(names_.matching));
}

}  // namespace mbncc::console

PLUGINLIB_EXPORT_CLASS(mbncc::console::TeachPanel, rviz::Panel)
