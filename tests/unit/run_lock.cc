// SPDX-License-Identifier: LGPL-2.1-or-later
// Who holds the lock of a folder, and whether that is known to have ended: what
// counts where a lock of the kernel does not reach all machines.
#include <lumbricus/output/run_lock.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace
{
  using lumbricus::LockHolder;

  // A process that is no more.
  std::string
  ended_process()
  {
    const pid_t child = fork();
    if (child == 0)
      _exit(EXIT_SUCCESS);
    waitpid(child, nullptr, 0);
    return std::to_string(child);
  }



  TEST(LockHolder, IsReadAsItWasWritten)
  {
    const LockHolder holder = LockHolder::this_process();
    EXPECT_EQ(holder.process, std::to_string(getpid()));
    EXPECT_FALSE(holder.host.empty());
    EXPECT_FALSE(holder.start.empty());
    const LockHolder again = LockHolder::read(holder.text());
    EXPECT_EQ(again.text(), holder.text());
    EXPECT_EQ(again.since, holder.since);
    EXPECT_TRUE(LockHolder::read("").host.empty());
    EXPECT_TRUE(LockHolder::read("host here\nprocess 1\n").host.empty());
  }



  TEST(LockHolder, ThatLivesHasNotEnded)
  {
    EXPECT_FALSE(LockHolder::this_process().has_ended());
    LockHolder parent = LockHolder::this_process();
    parent.process    = "1"; // the first of the machine
    // Its number alone does not say that it is the same process.
    EXPECT_TRUE(parent.has_ended());
  }



  TEST(LockHolder, ThatHasEnded)
  {
    LockHolder holder = LockHolder::this_process();
    holder.process    = ended_process();
    EXPECT_TRUE(holder.has_ended());
    holder      = LockHolder::this_process();
    holder.boot = "before";
    EXPECT_TRUE(holder.has_ended());
  }



  TEST(LockHolder, OnAnotherMachineMayLive)
  {
    LockHolder holder = LockHolder::this_process();
    holder.host += ".far.away";
    holder.process = ended_process();
    EXPECT_FALSE(holder.has_ended());
    holder      = LockHolder::this_process();
    holder.host = "";
    EXPECT_FALSE(holder.has_ended());
    holder.process = "../1";
    EXPECT_FALSE(holder.has_ended());
  }
} // namespace
