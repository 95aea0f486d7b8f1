// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Storage that grows and whose elements keep their addresses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/memory/large_vector.h"

namespace deltamesh::grid {

template <class T>
class Pieces {
 public:
  /// One more element, uninitialised.
  T& take() {
    if (left_ == 0) {
      left_ = count_ < kFew ? std::max<std::size_t>(count_, 8) : kLargePage / sizeof(T);
      pieces_.emplace_back(left_);
    }
    ++count_;
    return pieces_.back()[pieces_.back().size() - left_--];
  }
  void free() noexcept { *this = {}; }

 private:
  static constexpr std::size_t kFew = 64;  ///< elements; pieces after these fill a large page each

  std::vector<LargeVector<T>> pieces_;
  std::size_t count_ = 0;  ///< that were taken
  std::size_t left_ = 0;   ///< in the last piece
};

}  // namespace deltamesh::grid
