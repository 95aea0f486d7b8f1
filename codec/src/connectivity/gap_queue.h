// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Gaps in wait: the fullest go first, and among them the oldest [CONN-5].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "connectivity/border_item.h"

namespace deltamesh {

/// One queue for every number of faces. A gap is pushed again when it has more faces, and the older entries
/// are left behind; they are dropped where room is wanted, once the gap's item is removed, so that memory
/// follows the border's length.
class GapQueue {
 public:
  /// `faces`: 1 to kMostFaces, at the gap. Amortised O(1).
  template <class IsGone>
  void push(std::uint32_t faces, std::uint32_t gap, IsGone is_gone) {
    Bucket& bucket = buckets_[faces];
    if (bucket.end == bucket.room) make_room(bucket, is_gone);
    bucket.gaps[bucket.end++] = gap;
    fullest_ = std::max<std::size_t>(fullest_, faces);
  }

  /// The next gap that is not finished, or kNoIndex. Amortised O(1).
  template <class IsFinished>
  std::uint32_t pop(IsFinished is_finished) {
    for (;; --fullest_) {
      Bucket& bucket = buckets_[fullest_];
      while (bucket.begin < bucket.end) {
        const std::uint32_t gap = bucket.gaps[bucket.begin++];
        if (!is_finished(gap)) return gap;
      }
      bucket.begin = bucket.end = 0;
      if (fullest_ == 0) return kNoIndex;
    }
  }

 private:
  struct Bucket {
    std::vector<std::uint32_t> gaps;  ///< those from `begin` to `end` wait
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t room = 0;  ///< size of `gaps`
  };

  /// Drops gaps that are no more; a bucket that stays more than half full doubles.
  template <class IsGone>
  [[gnu::noinline]] static void make_room(Bucket& bucket, IsGone is_gone) {
    std::size_t end = 0;
    for (std::size_t i = bucket.begin; i < bucket.end; ++i) {
      const std::uint32_t gap = bucket.gaps[i];
      bucket.gaps[end] = gap;
      end += is_gone(gap) ? 0 : 1;
    }
    bucket.begin = 0;
    bucket.end = end;
    if (2 * end < bucket.room) return;
    bucket.room = std::max<std::size_t>(64, 2 * end);
    bucket.gaps.resize(bucket.room);
  }

  std::array<Bucket, kMostFaces + 1> buckets_;
  std::size_t fullest_ = 0;  ///< no bucket above it holds a gap
};

}  // namespace deltamesh
