// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/mailbox.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace mbncc::nodelets {
namespace {

TEST(MailboxTest, TheNewestReplacesAnOlderItem) {
  Mailbox<int> mailbox;
  EXPECT_FALSE(mailbox.put(1));
  EXPECT_TRUE(mailbox.put(2));
  EXPECT_EQ(mailbox.take(), 2);
  EXPECT_FALSE(mailbox.put(3)) << "the slot is free again";
}

TEST(MailboxTest, SeveralItemsWaitInTheirOrder) {
  Mailbox<int> mailbox(2);
  EXPECT_FALSE(mailbox.put(1));
  EXPECT_FALSE(mailbox.put(2));
  EXPECT_TRUE(mailbox.put(3)) << "the oldest is displaced";
  EXPECT_EQ(mailbox.take(), 2);
  EXPECT_EQ(mailbox.take(), 3);
}

TEST(MailboxTest, ClearDropsWaitingItems) {
  Mailbox<int> mailbox(2);
  mailbox.put(1);
  mailbox.put(2);
  mailbox.clear();
  mailbox.put(3);
  EXPECT_EQ(mailbox.take(), 3);
}

TEST(MailboxTest, CloseEndsAWaitingReaderAndEveryLaterOne) {
  Mailbox<int> mailbox;
  std::thread reader([&mailbox] { EXPECT_EQ(mailbox.take(), std::nullopt); });
  mailbox.close();
  reader.join();
  mailbox.put(1);
  EXPECT_EQ(mailbox.take(), std::nullopt);
}

}  // namespace
}  // namespace mbncc::nodelets
