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
  [[gnu::always_inline]] void push(std::uint32_t faces, std::uint32_t gap, IsGone is_gone) {
    Bucket& bucket = buckets_[faces];
    if (bucket.end == bucket.limit) make_room(bucket, is_gone);
    *bucket.end++ = gap;
    fullest_ = std::max(fullest_, faces);
  }

  /// The next gap that is not finished, or kNoIndex. Amortised O(1).
  template <class IsFinished>
  std::uint32_t pop(IsFinished is_finished) {
    for (;; --fullest_) {
      Bucket& bucket = buckets_[fullest_];
      while (bucket.begin < bucket.end) {
        const std::uint32_t gap = *bucket.begin++;
        if (!is_finished(gap)) return gap;
      }
      bucket.begin = bucket.end = bucket.gaps.data();
      if (fullest_ == 0) return kNoIndex;
    }
  }

 private:
  struct Bucket {
    std::uint32_t* begin = nullptr;  ///< those from here to `end` wait
    std::uint32_t* end = nullptr;
    std::uint32_t* limit = nullptr;  ///< end of `gaps`
    std::vector<std::uint32_t> gaps;
  };

  /// Drops gaps that are no more; a bucket that stays more than half full doubles.
  template <class IsGone>
  [[gnu::noinline]] static void make_room(Bucket& bucket, IsGone is_gone) {
    std::uint32_t* end = bucket.gaps.data();
    for (const std::uint32_t* gap = bucket.begin; gap != bucket.end; ++gap) {
      *end = *gap;
      end += is_gone(*gap) ? 0 : 1;
    }
    const auto count = static_cast<std::size_t>(end - bucket.gaps.data());
    if (2 * count >= bucket.gaps.size()) bucket.gaps.resize(std::max<std::size_t>(64, 2 * count));
    bucket.begin = bucket.gaps.data();
    bucket.end = bucket.begin + count;
    bucket.limit = bucket.begin + bucket.gaps.size();
  }

  std::array<Bucket, kMostFaces + 1> buckets_;
  std::uint32_t fullest_ = 0;  ///< no bucket above it holds a gap
};

}  // namespace deltamesh
