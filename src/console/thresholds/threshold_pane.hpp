// SPDX-License-Identifier: BSD-3-Clause
// Threshold sliders with a preview of their effect in the current image, for all objects or for the
// min_score of one object.
#pragma once

#ifndef Q_MOC_RUN
#include "console/thresholds/threshold_preview.hpp"
#endif

#include <QCheckBox>
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

  /// `object`: the one that can get its own threshold; "" if none is chosen.
  void begin(const Thresholds& now, const QString& object);
  void show_summary(const QString& summary) { summary_->setText(summary); }
  Thresholds wanted() const;
  /// The object whose min_score is being set; "" if the matcher's thresholds are.
  QString object() const { return one_->isChecked() ? object_ : QString(); }

 Q_SIGNALS:
  void moved();
  void apply_wanted();
  void closed();

 private:
  void lay_out();
  void set_scope();
  void tell();

  QLabel *min_text_, *confirm_text_, *summary_;
  QSlider *min_, *confirm_;
  QRadioButton *all_, *one_;
  QCheckBox* inherit_;   // use the matcher's min_score for that object
  QLabel* object_text_;  // names that object
  QString object_;
  Thresholds now_;
};

}  // namespace mbncc::console
