// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/threads/thread_team.h"

#include <new>
#include <system_error>
#include <utility>

namespace deltamesh {
namespace {

/// More would wait for each other: no job has many more pieces that take long.
constexpr unsigned kMostThreads = 16;

/// Looks for news before a thread goes to sleep, each of which yields: most come sooner than it could be
/// woken, which takes the one that wakes it some time as well. A fifth of a millisecond on an idle machine.
constexpr int kMostLooks = 512;

}  // namespace

ThreadTeam::ThreadTeam(unsigned threads) {
  const unsigned wanted = std::clamp(threads, 1U, kMostThreads) - 1;
  try {
    helpers_.reserve(wanted);  // so that none that runs is ever lost
    while (helpers_.size() < wanted) helpers_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // No more threads to be had: fewer, then.
  } catch (const std::bad_alloc&) {
    // No memory for them: the same.
  }
}

ThreadTeam::~ThreadTeam() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    ++news_;
  }
  offered_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadTeam::offer(TeamJob& job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(&job);
    ++news_;
  }
  offered_.notify_all();
}

void ThreadTeam::finish(TeamJob& job) {
  std::unique_lock lock(mutex_);
  while (job.next_ < job.pieces_) run_next(job, lock);
  if (job.done_ < job.pieces_) wait_briefly(lock);
  progressed_.wait(lock, [&] { return job.done_ == job.pieces_; });
  remove(job);
  if (job.error_) std::rethrow_exception(job.error_);
}

void ThreadTeam::withdraw(TeamJob& job) noexcept {
  std::unique_lock lock(mutex_);
  job.done_ += job.pieces_ - std::exchange(job.next_, job.pieces_);
  progressed_.wait(lock, [&] { return job.done_ == job.pieces_; });
  remove(job);
}

void ThreadTeam::help() {
  std::unique_lock lock(mutex_);
  while (true) {
    TeamJob* job = nullptr;
    if (first_open() == nullptr) wait_briefly(lock);
    offered_.wait(lock, [&] { return (job = first_open()) != nullptr || is_over_; });
    if (job == nullptr) return;
    run_next(*job, lock);
  }
}

void ThreadTeam::wait_briefly(std::unique_lock<std::mutex>& lock) {
  const std::uint32_t known = news_;
  lock.unlock();
  for (int look = 0; look < kMostLooks && news_ == known; ++look) std::this_thread::yield();
  lock.lock();
}

void ThreadTeam::run_next(TeamJob& job, std::unique_lock<std::mutex>& lock) {
  const std::uint32_t piece = job.next_++;
  lock.unlock();
  std::exception_ptr error;
  try {
    job.call_(job.work_, piece);
  } catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  ++job.done_;
  if (error) {
    if (!job.error_) job.error_ = error;
    job.done_ += job.pieces_ - std::exchange(job.next_, job.pieces_);
  }
  if (job.done_ < job.pieces_) return;
  ++news_;
  progressed_.notify_all();
}

TeamJob* ThreadTeam::first_open() noexcept {
  const auto found =
      std::find_if(jobs_.begin(), jobs_.end(), [](const TeamJob* job) { return job->next_ < job->pieces_; });
  return found == jobs_.end() ? nullptr : *found;
}

void ThreadTeam::remove(TeamJob& job) noexcept { std::erase(jobs_, &job); }

}  // namespace deltamesh
