// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/object_views.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mbncc {
namespace {

ObjectModel with_views(int count) {
  ObjectModel model;
  for (int k = 1; k <= count; ++k) {
    View view;
    view.reference = {10.0 * k, 0, 0.1 * k};
    model.views.push_back(view);
  }
  return model;
}

TEST(RemoveView, LeavesTheOthersAndTheirFrame) {
  for (int number = 1; number <= 3; ++number) {
    ObjectModel model = with_views(3);
    remove_view(model, static_cast<std::size_t>(number));
    ASSERT_EQ(model.views.size(), 2u);
    EXPECT_EQ(model.views[0].reference.x, number == 1 ? 20 : 10);
    EXPECT_EQ(model.views[1].reference.x, number == 3 ? 20 : 30);
  }
}

TEST(RemoveView, RefusesTheOnlyViewAndUnknownViews) {
  ObjectModel model = with_views(1);
  EXPECT_THROW(remove_view(model, 1), std::invalid_argument);
  model = with_views(2);
  for (const std::size_t number : {std::size_t{0}, std::size_t{3}})
    EXPECT_THROW(remove_view(model, number), std::invalid_argument);
  EXPECT_EQ(model.views.size(), 2u);
}

}  // namespace
}  // namespace mbncc
