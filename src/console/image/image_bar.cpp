// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_bar.hpp"

#include <QHBoxLayout>

#include "console/widgets.hpp"

namespace mbncc::console {
namespace {

constexpr const char* kRegionTip = "Draw a box; nothing is reported outside of it";

}  // namespace

ImageBar::ImageBar(QWidget* parent)
    : QWidget(parent),
      marks_(make_button("Hide marks", "Outlines and labels hide the image below them", "H")),
      all_(make_button("Show all", "The wheel or + zooms, dragging or arrow keys pan", "0")),
      region_(make_button("Search region", kRegionTip, "G")),
      camera_(make_button("Camera", "Focus, exposure and calibration", "K")),
      thresholds_(make_button("Thresholds", "The effect of other thresholds in this image", "S")),
      why_(make_button("Why not found here?", "Then click the place in the image", "W")) {
  marks_->setCheckable(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(marks_);
  row->addWidget(all_);
  row->addStretch(1);
  for (auto* button : {region_, camera_, thresholds_, why_}) row->addWidget(button);
  connect(marks_, &QPushButton::toggled, this, &ImageBar::marks_hidden);
  connect(all_, &QPushButton::clicked, this, &ImageBar::all_wanted);
  connect(region_, &QPushButton::clicked, this, &ImageBar::region_wanted);
  connect(camera_, &QPushButton::clicked, this, &ImageBar::camera_wanted);
  connect(thresholds_, &QPushButton::clicked, this, &ImageBar::thresholds_wanted);
  connect(why_, &QPushButton::clicked, this, &ImageBar::explanation_wanted);
}

void ImageBar::allow(bool cell, bool camera) {
  for (auto* button : {why_, thresholds_, region_}) button->setEnabled(cell);
  camera_->setEnabled(camera);
}

void ImageBar::show_region(bool limited) {
  relabel(region_, limited ? "Search everywhere" : "Search region");
  region_->setToolTip(QString(limited ? "Search the whole image again" : kRegionTip) + " (G)");
}

}  // namespace mbncc::console
