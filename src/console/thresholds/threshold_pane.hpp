// SPDX-License-Identifier: BSD-3-Clause
// Threshold sliders with a preview of their effect in the current picture; for all objects, or
// min_score of one object.
#pragma once

#ifndef Q_MOC_RUN
#include "console/thresholds/threshold_preview.hpp"
#endif

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QWidget>

namespace mbncc::console {

class ThresholdPane : public QWidget {
  Q_OBJECT

 public:
  explicit ThresholdPane(QWidget* parent = nullptr);

  /// `object`: the one that can get its own threshold; "": none is chosen.
  void begin(const Thresholds& now, const QString& object);
  void show_summary(const QString& summary) { summary_->setText(summary); }
  Thresholds wanted() const;

 Q_SIGNALS:
  void moved();
  /// `object`: only its min_score; "": the matcher's thresholds.
  void apply_wanted(QString object);
  void closed();

 private:
  void tell();

  QLabel *min_text_, *confirm_text_, *summary_;
  QSlider *min_, *confirm_;
  QRadioButton *all_, *one_;
  QLabel* object_text_;  // whose
  QString object_;
};

}  // namespace mbncc::console
