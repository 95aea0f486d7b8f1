// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Memory for elements that come one by one and stay where they are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/memory/large_vector.h"

namespace deltamesh::grid {

template <class T>
class Pieces {
 public:
  /// One more, uninitialised.
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
  static constexpr std::size_t kFew = 64;
  static constexpr std::size_t kLargePage = std::size_t{1} << 21;  ///< bytes; a piece fills one

  std::vector<LargeVector<T>> pieces_;
  std::size_t count_ = 0;  ///< that were taken
  std::size_t left_ = 0;   ///< in the last piece
};

}  // namespace deltamesh::grid
