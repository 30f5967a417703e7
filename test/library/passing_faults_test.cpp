// SPDX-License-Identifier: BSD-3-Clause
// Faults that pass although nobody changes the file.
#include <gtest/gtest.h>

#include <cerrno>

#include "library/fault_injection.hpp"
#include "library/models.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {
namespace {

FaultPlan failing_read(int error) {
  FaultPlan plan;
  plan.at = 0;
  plan.error = error;
  return plan;
}

TEST(PassingFaults, AnObjectThatCouldNotBeReadIsReadOnceItCan) {
  for (const int error : {EIO, EMFILE, ENOMEM, EACCES}) {
    TemporaryFolder folder;
    ObjectLibrary library(folder.path());
    library.save(random_model(1), ObjectLibrary::Existing::kRefuse);
    {
      const ArmedFault fault(failing_read(error));
      const auto snapshot = library.load();
      EXPECT_TRUE(snapshot->objects.empty());
      ASSERT_EQ(snapshot->quarantined.size(), 1u);
      EXPECT_FALSE(snapshot->quarantined[0].moved);
    }
    {
      const ArmedFault fault(failing_read(error));
      EXPECT_FALSE(library.changed_on_disk()) << "a lasting fault is not reported every second";
    }
    EXPECT_TRUE(library.changed_on_disk());
    EXPECT_NE(library.load()->find("wrench"), nullptr);
    EXPECT_FALSE(library.changed_on_disk());
  }
}

}  // namespace
}  // namespace mbncc::test
