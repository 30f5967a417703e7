// SPDX-License-Identifier: BSD-3-Clause
// The console as an RViz panel.
#pragma once

#ifndef Q_MOC_RUN
#include <rviz/panel.h>
#endif

#include "console/console_widget.hpp"

namespace mbncc::console {

class TeachPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit TeachPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void begin();

  Names names_;
  QWidget* console_ = nullptr;
};

}  // namespace mbncc::console
