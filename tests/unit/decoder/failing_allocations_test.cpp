// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decoding where memory runs out, at one allocation after the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "base/threads/thread_team.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "support/meshes.h"

namespace {

/// Allocations until one fails; below 0: none does any more.
std::atomic<long> allocations_left = -1;

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (allocations_left.fetch_sub(1, std::memory_order_relaxed) == 0) throw std::bad_alloc();
  const std::size_t whole = (std::max<std::size_t>(bytes, 1) + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, whole);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Not inlined, lest warnings see through them to free().
[[gnu::noinline]] void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, static_cast<std::size_t>(alignment));
}
// What std::stable_sort asks for; without it the sort goes on in place.
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  try {
    return allocate(bytes, alignof(std::max_align_t));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace deltamesh {
namespace {

/// Calls `work` with its allocation of every number failing, though not with each of the high ones.
template <class Work>
void fail_everywhere(const Work& work) {
  for (long number = 0;; number += 1 + number / 16) {
    SCOPED_TRACE(number);
    allocations_left = number;
    work();
    if (allocations_left.exchange(-1) >= 0) return;
  }
}

TEST(FailingAllocations, LeaveATeamWithFewerThreads) {
  fail_everywhere([] {
    const ThreadTeam team(4);
    EXPECT_LE(team.size(), 4U);
  });
}

TEST(FailingAllocations, AreErrorsOfDecodingOnAnyNumberOfThreads) {
  const Mesh mesh = test::attributed_grid(150, 130);
  for (const GeometryCoder geometry : {GeometryCoder::kHighpass, GeometryCoder::kPredictive}) {
    const auto encoded = encode(mesh, {.geometry = geometry});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_GT(encoded->bytes.size(), 1U << 14);  // shorter streams have no team
    for (const unsigned threads : {1U, 4U}) {
      SCOPED_TRACE(threads);
      const auto whole = decode(encoded->bytes);
      ASSERT_TRUE(whole);
      fail_everywhere([&] {
        const auto decoded = decode(encoded->bytes, {.threads = threads});
        if (decoded) {
          EXPECT_EQ(decoded->positions, whole->positions);
        } else {
          EXPECT_EQ(decoded.error().code, ErrorCode::kOutOfMemory);
        }
      });
      EXPECT_TRUE(encode(test::attributed_grid(3, 2), {}));
    }
  }
}

}  // namespace
}  // namespace deltamesh
