// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Gaps in wait: the fullest go first, and among them the oldest [CONN-5].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "connectivity/faces/border_item.h"

namespace deltamesh {

/// One queue for every number of faces. A gap is pushed again when it has more faces, and the older entries
/// are left behind; they are dropped where room is wanted, once the gap's item is removed, so that memory
/// follows the border's length.
class GapQueue {
 public:
  GapQueue() = default;
  GapQueue(const GapQueue&) = delete;  // buckets point into their own arrays
  GapQueue& operator=(const GapQueue&) = delete;

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
      bucket.begin = bucket.end = bucket.room.get();
      if (fullest_ == 0) return kNoIndex;
    }
  }

 private:
  struct Bucket {
    std::uint32_t* begin = nullptr;  ///< those from here to `end` wait
    std::uint32_t* end = nullptr;
    std::uint32_t* limit = nullptr;  ///< of the room
    std::unique_ptr<std::uint32_t[]> room;
  };

  /// Drops gaps that are no more; where half of them or more stay there will be room for four times as many.
  template <class IsGone>
  [[gnu::noinline]] static void make_room(Bucket& bucket, IsGone is_gone) {
    std::uint32_t* end = bucket.room.get();
    for (const std::uint32_t* gap = bucket.begin; gap != bucket.end; ++gap) {
      *end = *gap;
      end += is_gone(*gap) ? 0 : 1;
    }
    bucket.begin = bucket.room.get();
    bucket.end = end;
    const std::ptrdiff_t count = end - bucket.begin;
    if (2 * count < bucket.limit - bucket.begin) return;
    const std::ptrdiff_t size = std::max<std::ptrdiff_t>(64, 4 * count);
    std::unique_ptr<std::uint32_t[]> room(new std::uint32_t[static_cast<std::size_t>(size)]);
    bucket.end = std::copy(bucket.begin, end, room.get());
    bucket.begin = room.get();
    bucket.limit = bucket.begin + size;
    bucket.room = std::move(room);
  }

  std::array<Bucket, kMostFaces + 1> buckets_;
  std::uint32_t fullest_ = 0;  ///< no bucket above it holds a gap
};

}  // namespace deltamesh
