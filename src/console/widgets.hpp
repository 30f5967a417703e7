// SPDX-License-Identifier: BSD-3-Clause
// Helpers shared by the console's widgets.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QWidget>
#include <cstdint>

#include "console/words.hpp"

namespace mbncc::console {

/// With MBNCC_CONSOLE_NATIVE set, gives `widget` its own X window named "mbncc:" and `title`, with
/// " (disabled)" appended while it is disabled, so that xdotool finds it.
void name_window(QWidget* widget, const QString& title);

/// `keys`: shown in the tooltip, such as "Alt+T".
QPushButton* make_button(const QString& text, const QString& tip, QWidget* parent,
                         const QString& keys = "");

/// The choices of symmetry_choices(), their values as data.
QComboBox* make_symmetry_box(const QString& tip);

/// The value chosen there, and its choice.
std::uint8_t chosen_symmetry(const QComboBox* box);
void choose_symmetry(QComboBox* box, std::uint8_t value);

/// Symbol and `text`, in the level's colour.
void show_level(QLabel* label, Level level, const QString& text);

}  // namespace mbncc::console
