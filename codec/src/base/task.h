// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A result that another thread may be working on.
#pragma once

#include <future>
#include <system_error>
#include <utility>

namespace deltamesh {

/// Calls `work` on a thread of its own, or, where that is not wanted or no thread can be had, when the result
/// is asked for. Whatever `work` refers to must outlive this; the destructor waits for a thread that is at
/// it.
template <class T>
class Task {
 public:
  template <class Work>
  Task(bool on_own_thread, const Work& work) {
    try {
      if (on_own_thread) future_ = std::async(std::launch::async, work);
    } catch (const std::system_error&) {
      // No thread to be had: later, then.
    }
    if (!future_.valid()) future_ = std::async(std::launch::deferred, work);
  }

  /// Once. Throws what `work` throws.
  T get() { return future_.get(); }

 private:
  std::future<T> future_;
};

}  // namespace deltamesh
