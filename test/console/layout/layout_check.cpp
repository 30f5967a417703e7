// SPDX-License-Identifier: BSD-3-Clause
// Checks the widgets of a running Qt program for text that is cut off, and for widgets that are
// covered or out of reach. Qt loads it if QT_QPA_GENERIC_PLUGINS=layoutcheck and QT_PLUGIN_PATH
// contains the parent of this library's folder. Several times per second it writes the file
// MBNCC_LAYOUT_REPORT: {"looks": number of checks so far, "focus": the widget with the focus,
// "texts": texts of labels and painted widgets, "complaints": [...]}.
#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QGenericPlugin>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMainWindow>
#include <QSaveFile>
#include <QScreen>
#include <QScrollBar>
#include <QTableWidget>
#include <QTimer>
#include <vector>

namespace {

constexpr int kEvery = 150;  // [ms]

QString name_of(const QWidget* widget) {
  if (widget == nullptr) return "";
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
    if (!button->text().isEmpty()) return QString(button->text()).remove('&');
  if (!widget->objectName().isEmpty()) return widget->objectName();
  if (const auto* label = qobject_cast<const QLabel*>(widget)) return "'" + label->text() + "'";
  return widget->metaObject()->className();
}

QString text_of(const QRect& r) {
  return QString("%1x%2 at %3, %4").arg(r.width()).arg(r.height()).arg(r.x()).arg(r.y());
}

class Look {
 public:
  QJsonArray complaints() {
    for (auto* top : QApplication::topLevelWidgets())
      if (top->isVisible() && top->windowType() != Qt::ToolTip) look_at_window(*top);
    return complaints_;
  }

 private:
  void complain(const QWidget& of, const QString& what) {
    complaints_ << name_of(&of) + ": " + what;
  }

  void look_at_window(QWidget& top) {
    const QRect screen = QGuiApplication::primaryScreen()->geometry();
    if (!screen.contains(top.frameGeometry()))
      complain(top,
               "window " + text_of(top.frameGeometry()) + " exceeds the screen " + text_of(screen));
    QHash<QString, QString> mnemonics;
    for (auto* widget : top.findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->window() != &top) continue;
      look_at_children(*widget);
      look_at_text(*widget);
      if (const auto* button = qobject_cast<QAbstractButton*>(widget))
        if (button->isEnabled()) look_at_mnemonic(*button, mnemonics);
    }
    look_at_children(top);
    look_at_tab_order(top);
  }

  static std::vector<QWidget*> laid_out(const QWidget& parent) {
    std::vector<QWidget*> children;
    if (parent.layout() == nullptr) return children;
    for (auto* child : parent.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (child->isVisible() && !child->isWindow()) children.push_back(child);
    return children;
  }

  void look_at_children(const QWidget& parent) {
    const auto children = laid_out(parent);
    for (std::size_t i = 0; i < children.size(); ++i) {
      const QRect box = children[i]->geometry();
      if (!parent.rect().contains(box))
        complain(*children[i],
                 text_of(box) + " exceeds " + name_of(&parent) + " " + text_of(parent.rect()));
      for (std::size_t j = 0; j < i; ++j)
        if (box.intersects(children[j]->geometry()))
          complain(*children[i], "covers " + name_of(children[j]));
    }
  }

  void needs(const QWidget& widget, const QSize& needed) {
    if (needed.width() > widget.width() || needed.height() > widget.height())
      complain(widget, QString("needs %1x%2, has %3x%4")
                           .arg(needed.width())
                           .arg(needed.height())
                           .arg(widget.width())
                           .arg(widget.height()));
  }

  void look_at_text(const QWidget& widget) {
    if (const auto* area = qobject_cast<const QAbstractScrollArea*>(&widget)) {
      if (area->horizontalScrollBar()->isVisible()) complain(widget, "scrolls sideways");
      if (qobject_cast<const QMainWindow*>(area->parentWidget()) &&
          area->verticalScrollBar()->isVisible())
        complain(widget, "the whole window scrolls");
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
      if (label->text().isEmpty()) return;
      if (label->text().contains(QChar(0x2026))) complain(widget, "elided");
      needs(widget, label->wordWrap() ? QSize(0, label->heightForWidth(label->width()))
                                      : label->sizeHint());
    } else if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) {
      if (edit->text().isEmpty())
        needs(widget, {edit->fontMetrics().horizontalAdvance(edit->placeholderText()) + 6, 0});
    } else if (const auto* table = qobject_cast<const QTableWidget*>(&widget)) {
      look_at_table(*table);
    } else if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
      needs(widget, {box->fontMetrics().horizontalAdvance(box->currentText()) + 24,
                     box->minimumSizeHint().height()});
    } else if (qobject_cast<const QAbstractSpinBox*>(&widget)) {
      needs(widget, widget.minimumSizeHint());
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
      if (!button->text().isEmpty()) needs(widget, button->minimumSizeHint());
    }
  }

  void look_at_table(const QTableWidget& table) {
    for (int row = 0; row < table.rowCount(); ++row)
      for (int column = 0; column < table.columnCount(); ++column) {
        const auto* cell = table.item(row, column);
        if (cell == nullptr || table.isColumnHidden(column)) continue;
        if (table.fontMetrics().horizontalAdvance(cell->text()) + 6 > table.columnWidth(column))
          complain(table, "'" + cell->text() + "' is wider than its column");
      }
  }

  void look_at_mnemonic(const QAbstractButton& button, QHash<QString, QString>& known) {
    const QString keys = button.shortcut().toString();
    if (keys.isEmpty()) return;
    if (known.contains(keys)) complain(button, keys + " is " + known[keys] + ", too");
    known[keys] = name_of(&button);
  }

  /// Tab should go line by line, and from left to right within a line.
  void look_at_tab_order(QWidget& top) {
    QHash<const QWidget*, const QWidget*> last;  // by parent
    const QWidget* widget = &top;
    while ((widget = widget->nextInFocusChain()) != &top) {
      const QWidget* parent = widget->parentWidget();
      const bool stops = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisible() &&
                         widget->window() == &top;
      if (!stops || parent == nullptr || parent->layout() == nullptr) continue;
      if (const QWidget* before = last.value(parent)) {
        const bool above = before->geometry().bottom() <= widget->geometry().top();
        const bool beside = before->geometry().right() <= widget->geometry().left() &&
                            before->geometry().top() <= widget->geometry().bottom();
        if (!above && !beside) complain(*widget, "Tab comes to it after " + name_of(before));
      }
      last[parent] = widget;
    }
  }

  QJsonArray complaints_;
};

/// Texts in the windows; a widget that paints its text describes it for screen readers.
QJsonArray texts() {
  QJsonArray texts;
  for (const auto* widget : QApplication::allWidgets()) {
    if (!widget->isVisible()) continue;
    const auto* label = qobject_cast<const QLabel*>(widget);
    for (const auto& text :
         {label != nullptr ? label->text() : "", widget->accessibleDescription()})
      if (!text.isEmpty()) texts << text;
  }
  return texts;
}

class LayoutCheck : public QObject {
 public:
  LayoutCheck() {
    connect(&timer_, &QTimer::timeout, this, [this] { report(); });
    timer_.start(kEvery);
  }

 private:
  void report() {
    QSaveFile file(qEnvironmentVariable("MBNCC_LAYOUT_REPORT"));
    if (!file.open(QIODevice::WriteOnly)) return;
    file.write(QJsonDocument(QJsonObject{{"looks", ++looks_},
                                         {"focus", name_of(QApplication::focusWidget())},
                                         {"texts", texts()},
                                         {"complaints", Look().complaints()}})
                   .toJson());
    file.commit();
  }

  QTimer timer_;
  int looks_ = 0;
};

class LayoutCheckPlugin : public QGenericPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "layout_check.json")

 public:
  QObject* create(const QString&, const QString&) override { return new LayoutCheck; }
};

}  // namespace

#include "layout_check.moc"
