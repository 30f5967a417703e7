// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_strip.hpp"

#include <gtest/gtest.h>

#include <QApplication>

namespace mbncc::console {
namespace {

class LibraryStripTest : public testing::Test {
 protected:
  void SetUp() override {
    show({"bracket", "wrench"});
    list_->setCurrentRow(0);
  }

  void show(const std::vector<std::string>& names) {
    std::vector<mbncc_vision::LearnedObject> objects;
    for (const auto& name : names) objects.emplace_back().name = name;
    library_.set_objects(objects);
    strip_.show_objects(library_);
  }

  LibraryModel library_;
  LibraryStrip strip_;
  QListWidget* list_ = strip_.findChild<QListWidget*>("library");
  QPushButton* delete_ = strip_.findChild<QPushButton*>("Delete");
};

TEST_F(LibraryStripTest, AnObjectThatTheSearchHidesIsNotChosen) {
  ASSERT_EQ(strip_.chosen(), "bracket");
  EXPECT_TRUE(delete_->isEnabled());
  strip_.findChild<QLineEdit*>("search")->setText("wrench");
  EXPECT_EQ(strip_.chosen(), "");
  EXPECT_FALSE(delete_->isEnabled());
}

TEST_F(LibraryStripTest, ANewNameIsWrittenToTheEndBeforeTheListIsShownAnew) {
  list_->editItem(list_->currentItem());
  auto* editor = list_->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  editor->setText("angle");
  show({"bracket", "clamp", "wrench"});
  QApplication::processEvents();
  ASSERT_EQ(list_->viewport()->findChild<QLineEdit*>(), editor);
  EXPECT_EQ(list_->count(), 2);
  std::string name;
  QObject::connect(&strip_, &LibraryStrip::edit_wanted,
                   [&name](const auto& request) { name = request.new_name; });
  Q_EMIT list_->itemDelegate()->commitData(editor);
  Q_EMIT list_->itemDelegate()->closeEditor(editor);
  EXPECT_EQ(name, "angle");
  QApplication::processEvents();
  EXPECT_EQ(list_->count(), 3);
}

}  // namespace
}  // namespace mbncc::console
