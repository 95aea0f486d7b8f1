// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A few threads that share the work of one call. What is done does not depend on how many there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/machine.h"

namespace deltamesh {

/// Pieces of work that any thread may run, in any order. Must live until finish() or withdraw() returns.
class TeamJob {
 public:
  using Call = void (*)(const void* work, std::uint32_t piece);

  TeamJob(std::uint32_t pieces, Call call, const void* work) noexcept
      : pieces_(pieces), call_(call), work_(work) {}

 private:
  friend class ThreadTeam;

  std::uint32_t pieces_;
  std::uint32_t next_ = 0;  ///< first piece that no thread has taken
  std::uint32_t done_ = 0;
  Call call_;
  const void* work_;
  std::exception_ptr error_;
};

/// A pool of threads for the work of one call. A piece may offer jobs of its own.
class ThreadTeam {
 public:
  /// `threads`: how many, the calling one included, at most 16; fewer where the system has no more, or no
  /// memory for them.
  explicit ThreadTeam(unsigned threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Number of threads, the one that made this included.
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(helpers_.size()) + 1; }

  /// Adds a job. Free threads take pieces of jobs in the order of offers.
  void offer(TeamJob& job);

  /// Runs the pieces that are not taken and waits for the others. Throws what a piece has thrown; pieces that
  /// are not taken by then are left out.
  void finish(TeamJob& job);

  /// Waits for the pieces that are running; the others are left out.
  void withdraw(TeamJob& job) noexcept;

 private:
  void help();
  void wait_briefly(std::unique_lock<std::mutex>& lock);
  void run_next(TeamJob& job, std::unique_lock<std::mutex>& lock);
  TeamJob* first_open() noexcept;
  void remove(TeamJob& job) noexcept;

  std::mutex mutex_;  ///< of all below and of the jobs
  std::condition_variable offered_;
  std::condition_variable progressed_;
  std::vector<TeamJob*> jobs_;
  bool is_over_ = false;
  std::atomic<std::uint32_t> news_ = 0;  ///< counts offers and finished jobs
  std::vector<std::thread> helpers_;
};

/// Calls work(piece) for every piece below `pieces`, each once, on this thread and those of `team`, which is
/// null where there is none. Throws what one of them throws.
template <class Work>
void share_work(ThreadTeam* team, std::uint32_t pieces, const Work& work) {
  if (!kHasThreads || team == nullptr || pieces <= 1) {
    for (std::uint32_t piece = 0; piece < pieces; ++piece) work(piece);
    return;
  }
  TeamJob job(
      pieces, [](const void* any, std::uint32_t piece) { (*static_cast<const Work*>(any))(piece); }, &work);
  team->offer(job);
  team->finish(job);
}

/// How many pieces `rows` are best shared in; 1 without a team.
inline std::uint32_t piece_count(const ThreadTeam* team, std::size_t rows) noexcept {
  constexpr std::size_t kFewestRows = 8192;  // done sooner than another thread has begun
  constexpr std::uint32_t kPiecesPerThread = 4;
  if (!kHasThreads || team == nullptr || rows < 2 * kFewestRows) return 1;
  return static_cast<std::uint32_t>(
      std::min<std::size_t>(kPiecesPerThread * team->size(), rows / kFewestRows));
}

/// First row of a piece when `rows` rows are divided into `pieces`; a piece ends where the next one begins.
inline std::uint32_t piece_begin(std::size_t rows, std::uint32_t pieces, std::uint32_t piece) noexcept {
  return static_cast<std::uint32_t>(std::uint64_t{rows} * piece / pieces);
}

/// work(begin, end) for ranges that make up all of `rows`.
template <class Work>
void share_rows(ThreadTeam* team, std::size_t rows, const Work& work) {
  const std::uint32_t pieces = piece_count(team, rows);
  share_work(team, pieces, [&](std::uint32_t piece) {
    work(piece_begin(rows, pieces, piece), piece_begin(rows, pieces, piece + 1));
  });
}

/// each(row) for all rows below `rows`, which must not depend on each other.
template <class Each>
void share_each(ThreadTeam* team, std::size_t rows, const Each& each) {
  share_rows(team, rows, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t row = begin; row < end; ++row) each(row);
  });
}

}  // namespace deltamesh
