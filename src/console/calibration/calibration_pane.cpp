// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/calibration_pane.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "console/calibration/coverage_view.hpp"
#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr int kLookEvery = 400;  // [ms]
constexpr std::size_t kFewest = 3;

QSpinBox* make_count(int value, const QString& tip) {
  auto* box = new QSpinBox;
  box->setRange(3, 40);
  box->setValue(value);
  box->setToolTip(tip);
  return box;
}

QDoubleSpinBox* make_length(double least, double most, double value, const QString& suffix,
                            const QString& tip) {
  auto* box = new QDoubleSpinBox;
  box->setRange(least, most);
  box->setDecimals(2);
  box->setValue(value);
  box->setSuffix(suffix);
  box->setToolTip(tip);
  return box;
}

}  // namespace

CalibrationPane::CalibrationPane(QWidget* parent)
    : QWidget(parent),
      columns_(make_count(Board().columns, "inner corners along the board")),
      rows_(make_count(Board().rows, "inner corners across the board")),
      square_(make_length(0.5, 500, 1000 * Board().square, " mm squares", "side of a square")),
      thickness_(make_length(0, 100, 0, " mm thick",
                             "height of the board's printed face above the platform")),
      coverage_(new CoverageView),
      image_text_(new QLabel),
      board_text_(new QLabel),
      result_text_(new QLabel),
      compute_(make_button("Comp&ute", "From the images recorded so far", "Alt+U")),
      keep_(make_button("&Keep", "The camera uses this calibration from now on", "Alt+K")),
      start_over_(make_button("&Start over", "Discard the recorded images", "Alt+S")),
      platform_(
          make_button("Plat&form", "From the board that lies flat on the platform", "Alt+F")) {
  name_window(thickness_, "thickness");
  for (auto* text : {image_text_, board_text_, result_text_}) text->setWordWrap(true);
  result_text_->setTextInteractionFlags(Qt::TextSelectableByMouse);  // a path to copy
  QFont bold = result_text_->font();
  bold.setBold(true);
  result_text_->setFont(bold);
  auto* close = make_button("&Back to live", "Close without further changes", "Esc");
  auto* board = new QHBoxLayout;
  board->addWidget(new QLabel("Chessboard"));
  board->addWidget(columns_);
  board->addWidget(new QLabel(QString::fromUtf8("\u00d7")));
  board->addWidget(rows_);
  board->addWidget(square_, 1);
  auto* platform = new QHBoxLayout;
  platform->addWidget(new QLabel("On the platform"));
  platform->addWidget(thickness_, 1);
  auto* buttons = new QGridLayout;
  buttons->addWidget(compute_, 0, 0);
  buttons->addWidget(keep_, 0, 1);
  buttons->addWidget(start_over_, 1, 0);
  buttons->addWidget(platform_, 1, 1);
  buttons->addWidget(close, 2, 0, 1, 2);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(image_text_);
  all->addLayout(board);
  all->addLayout(platform);
  all->addWidget(board_text_);
  all->addWidget(result_text_);
  all->addWidget(coverage_, 1);
  all->addLayout(buttons);
  for (auto* box : {columns_, rows_})
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, &CalibrationPane::start_over);
  connect(square_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          &CalibrationPane::start_over);
  connect(compute_, &QPushButton::clicked, this, &CalibrationPane::compute);
  connect(start_over_, &QPushButton::clicked, this, &CalibrationPane::start_over);
  connect(keep_, &QPushButton::clicked, this, [this] { Q_EMIT keep_wanted(result_.info); });
  connect(platform_, &QPushButton::clicked, this, &CalibrationPane::platform_wanted);
  connect(&platform_calibration_, &PlatformCalibration::ended, this,
          &CalibrationPane::show_platform);
  connect(close, &QPushButton::clicked, this, &CalibrationPane::closed);
}

void CalibrationPane::begin() {
  check_ = ImageCheck();
  size_ = QSize();
  start_over();
}

Board CalibrationPane::board() const {
  return {columns_->value(), rows_->value(), square_->value() / 1000};
}

void CalibrationPane::start_over() {
  calibration_ = BoardCalibration(board(), {size_.width(), size_.height()});
  marks_.clear();
  coverage_->show_coverage(calibration_);
  result_text_->clear();
  compute_->setEnabled(false);
  keep_->setEnabled(false);
}

std::vector<Mark> CalibrationPane::take(const QImage& image, QSize size) {
  if (since_look_.isValid() && since_look_.elapsed() < kLookEvery) return marks_;
  since_look_.start();
  if (size != size_) {
    size_ = size;
    start_over();
  }
  const QImage rgb = image.convertToFormat(QImage::Format_RGB888);
  const cv::Mat pixels(rgb.height(), rgb.width(), CV_8UC3, const_cast<uchar*>(rgb.bits()),
                       static_cast<std::size_t>(rgb.bytesPerLine()));
  check_.take(pixels);
  image_text_->setText(QString::fromStdString(check_.advice()));
  const auto seen = calibration_.take(pixels);
  board_text_->setText(QString::fromStdString(calibration_.advice(seen)));
  if (seen == BoardCalibration::Seen::kTaken) coverage_->show_coverage(calibration_);
  compute_->setEnabled(calibration_.views() >= kFewest);
  marks_.clear();
  if (calibration_.corners().empty()) return marks_;
  Mark mark;
  mark.outlines = {calibration_.outline()};
  mark.origin = calibration_.corners().front();
  mark.level = seen == BoardCalibration::Seen::kTaken ? Level::kGood : Level::kUnknown;
  mark.label = seen == BoardCalibration::Seen::kTaken ? "taken" : "board";
  marks_ = {mark};
  return marks_;
}

void CalibrationPane::compute() {
  result_ = calibration_.solve();
  result_text_->setText(
      QString("Reprojection error %1 mm on the board (%2 px); focal length %3 px. %4")
          .arg(result_.error_mm, 0, 'f', 2)
          .arg(result_.error_px, 0, 'f', 2)
          .arg(result_.info.K[0], 0, 'f', 0)
          .arg(!result_.determined()
                   ? "The images do not determine the focal length: start over and tilt the board "
                     "by about 30 degrees, each time in another direction."
               : calibration_.suffices()
                   ? "Keep it, or continue."
                   : "The images cover too little for a reliable calibration."));
  keep_->setEnabled(result_.determined());
}

void CalibrationPane::show_kept(bool success, const QString& message) {
  result_text_->setText(success
                            ? "Stored. The platform's pose still rests on the old calibration, so "
                              "there are no poses in metres if calibrate_platform measured it: lay "
                              "the board flat on the platform, press Platform, and start the cell "
                              "again with the result. A pose measured by other means is used on: "
                              "measure it again before a robot moves."
                            : "Not kept: " + message);
}

void CalibrationPane::calibrate_platform(const CellImages& images) {
  platform_->setEnabled(false);
  result_text_->setText("The platform is being calibrated; do not move the board.");
  platform_calibration_.begin(board(), thickness_->value() / 1000, images);
}

void CalibrationPane::show_platform(bool success, const QString& message) {
  platform_->setEnabled(true);
  result_text_->setText(success ? message : "Platform not calibrated: " + message);
}

}  // namespace mbncc::console
