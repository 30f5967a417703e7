// SPDX-License-Identifier: BSD-3-Clause
// Helpers shared by the console's widgets.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QString>
#include <QWidget>
#include <cstdint>

#include "console/words.hpp"

namespace mbncc::console {

/// With MBNCC_CONSOLE_NATIVE set, gives `widget` its own X window named "mbncc:" and `title`, with
/// " (disabled)" appended while it is disabled, so that xdotool finds it.
void name_window(QWidget* widget, const QString& title);

/// `keys` appear in the tooltip, such as "Alt+T". Without a parent, Tab visits a layout's widgets
/// in the order in which they got their parent.
QPushButton* make_button(const QString& text, const QString& tip, const QString& keys = "");

/// Changes the text of a button whose meaning has changed, and the name of its window.
void relabel(QPushButton* button, const QString& text);

/// `content` with scroll bars if there is too little space for it: widgets with too little space
/// paint over their neighbours.
QScrollArea* make_scroll_area(QWidget* content);

/// A box with the texts of symmetry_choices(), and their values as data.
QComboBox* make_symmetry_box(const QString& tip);

/// The value chosen in such a box, and its choice.
std::uint8_t chosen_symmetry(const QComboBox* box);
void choose_symmetry(QComboBox* box, std::uint8_t value);

/// Shows symbol and `text` in the level's colour.
void show_level(QLabel* label, Level level, const QString& text);

/// Colours a sentence that reports a problem; others stay plain.
void show_alarm(QLabel* label, Level level);

}  // namespace mbncc::console
