// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/threads/thread_team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <vector>

#include "base/threads/task.h"

namespace deltamesh {
namespace {

TEST(Task, GivesTheResultWhereverItRuns) {
  for (const unsigned threads : {1U, 2U}) {
    ThreadTeam team(threads);
    Task task(&team, [] { return 7; });
    EXPECT_EQ(task.get(), 7);
  }
}

TEST(Task, RunsOnlyWhenAskedWithoutATeam) {
  bool ran = false;
  const auto work = [&] {
    ran = true;
    return 1;
  };
  { const Task task(nullptr, work); }
  EXPECT_FALSE(ran);
  Task task(nullptr, work);
  EXPECT_EQ(task.get(), 1);
  EXPECT_TRUE(ran);
}

TEST(Task, HandsAFailedAllocationOn) {
  for (const unsigned threads : {1U, 2U}) {
    ThreadTeam team(threads);
    Task task(&team, []() -> int { throw std::bad_alloc(); });
    EXPECT_THROW(task.get(), std::bad_alloc);
  }
}

TEST(ThreadTeam, DoesEveryPieceOnce) {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    SCOPED_TRACE(threads);
    ThreadTeam team(threads);
    for (int round = 0; round < 50; ++round) {
      std::vector<int> times(37, 0);
      share_work(&team, 37, [&](std::uint32_t piece) { ++times[piece]; });
      EXPECT_EQ(times, std::vector<int>(37, 1));
    }
  }
}

TEST(ThreadTeam, HelpsWithWorkWithinAPiece) {
  ThreadTeam team(3);
  std::atomic<int> times = 0;
  for (int round = 0; round < 50; ++round)
    share_work(&team, 7, [&](std::uint32_t) { share_work(&team, 5, [&](std::uint32_t) { ++times; }); });
  EXPECT_EQ(times, 50 * 7 * 5);
}

TEST(ThreadTeam, HandsAFailedAllocationOn) {
  ThreadTeam team(3);
  const auto fail = [](std::uint32_t piece) {
    if (piece == 5) throw std::bad_alloc();
  };
  EXPECT_THROW(share_work(&team, 9, fail), std::bad_alloc);
  EXPECT_NO_THROW(share_work(&team, 5, fail));
}

}  // namespace
}  // namespace deltamesh
