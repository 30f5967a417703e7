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

/// `keys`: shown in the tip, such as "Alt+T". Without a parent: Tab goes through a layout's widgets
/// in the order in which they were given one.
QPushButton* make_button(const QString& text, const QString& tip, const QString& keys = "");

/// Another text for a button whose meaning has changed, and another name for its window.
void relabel(QPushButton* button, const QString& text);

/// `content` with scroll bars where there is too little room for it: widgets that get too little
/// paint over their neighbours.
QScrollArea* make_scroll_area(QWidget* content);

/// The choices of symmetry_choices(), their values as data.
QComboBox* make_symmetry_box(const QString& tip);

/// The value chosen there, and its choice.
std::uint8_t chosen_symmetry(const QComboBox* box);
void choose_symmetry(QComboBox* box, std::uint8_t value);

/// Symbol and `text`, in the level's colour.
void show_level(QLabel* label, Level level, const QString& text);

/// Colours a sentence that complains; others stay plain.
void show_alarm(QLabel* label, Level level);

}  // namespace mbncc::console
