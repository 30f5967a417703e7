// SPDX-License-Identifier: BSD-3-Clause
#include "console/widgets.hpp"

#include <QEvent>
#include <QWindow>
#include <utility>

namespace mbncc::console {

namespace {

/// Names a widget's X window once it exists; Qt itself names only top-level windows.
class WindowNamer : public QObject {
 public:
  explicit WindowNamer(QWidget* widget) : QObject(widget) { widget->installEventFilter(this); }

  bool eventFilter(QObject* object, QEvent* event) override {
    const auto type = event->type();
    if (type == QEvent::Show || type == QEvent::WinIdChange || type == QEvent::EnabledChange)
      name(*static_cast<QWidget*>(object));
    return false;
  }

  static void name(const QWidget& widget) {
    if (auto* window = widget.windowHandle())
      window->setTitle("mbncc:" + widget.objectName() + (widget.isEnabled() ? "" : " (disabled)"));
  }
};

}  // namespace

void name_window(QWidget* widget, const QString& title) {
  widget->setObjectName(title);
  if (!qEnvironmentVariableIsSet("MBNCC_CONSOLE_NATIVE")) return;
  widget->setAttribute(Qt::WA_DontCreateNativeAncestors);
  widget->setAttribute(Qt::WA_NativeWindow);
  new WindowNamer(widget);
}

QPushButton* make_button(const QString& text, const QString& tip, const QString& keys) {
  auto* button = new QPushButton(text);
  button->setToolTip(keys.isEmpty() ? tip : tip + " (" + keys + ")");
  name_window(button, QString(text).remove('&'));
  return button;
}

void relabel(QPushButton* button, const QString& text) {
  button->setText(text);
  button->setObjectName(QString(text).remove('&'));
  if (button->testAttribute(Qt::WA_NativeWindow)) WindowNamer::name(*button);
}

QScrollArea* make_scroll_area(QWidget* content) {
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(content);
  return area;
}

QComboBox* make_symmetry_box(const QString& tip) {
  auto* box = new QComboBox;
  for (const auto& choice : symmetry_choices())
    box->addItem(QString::fromStdString(choice.text), choice.value);
  box->setToolTip(tip);
  return box;
}

std::uint8_t chosen_symmetry(const QComboBox* box) {
  return static_cast<std::uint8_t>(box->currentData().toUInt());
}

void choose_symmetry(QComboBox* box, std::uint8_t value) {
  box->setCurrentIndex(box->findData(value));
}

void show_level(QLabel* label, Level level, const QString& text) {
  label->setText(QString::fromUtf8(symbol_of(level)) + " " + text);
  label->setStyleSheet(QString("QLabel { background: %1; color: %2; font-weight: bold; "
                               "border-radius: 4px; padding: 3px 8px; }")
                           .arg(colour_of(level), ink_on(level)));
}

void show_alarm(QLabel* label, Level level) {
  const bool alarming = level == Level::kBad || level == Level::kDoubtful;
  label->setStyleSheet(
      alarming ? QString("background: %1; color: %2; font-weight: bold; padding: 0px 6px")
                     .arg(colour_of(level), ink_on(level))
               : "");
}

}  // namespace mbncc::console
