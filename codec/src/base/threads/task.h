// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A result that another thread may be working on.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "base/threads/thread_team.h"

namespace deltamesh {

/// Calls `work` on a thread of `team`, or, where none is free or that is null, when the result is asked for.
/// Whatever `work` refers to must outlive this; the destructor waits for a thread that is at it.
template <class Work>
class Task {
 public:
  Task(ThreadTeam* team, Work work) : work_(std::move(work)), team_(team), job_(1, &Task::run, this) {
    if (kHasThreads && team_ != nullptr) team_->offer(job_);
  }
  ~Task() {
    if (kHasThreads && team_ != nullptr) team_->withdraw(job_);
  }
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  /// Once. Throws what `work` throws.
  auto get() {
    ThreadTeam* const team = std::exchange(team_, nullptr);
    if (!kHasThreads || team == nullptr) {
      run(this, 0);
    } else {
      team->finish(job_);
    }
    return *std::move(result_);
  }

 private:
  static void run(const void* task, std::uint32_t) {
    const auto* const self = static_cast<const Task*>(task);
    self->result_.emplace(self->work_());
  }

  Work work_;
  mutable std::optional<std::invoke_result_t<const Work&>> result_;
  ThreadTeam* team_;
  TeamJob job_;
};

}  // namespace deltamesh
