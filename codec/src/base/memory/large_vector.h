// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Memory for large arrays. Half of what a plain one costs is the system's handing it out page by page and the
// clearing before it is overwritten: here pages are large, and nothing is cleared twice.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace deltamesh {

/// Smaller than some systems' large pages, which then are not used.
inline constexpr std::size_t kLargePage = std::size_t{1} << 21;

/// `bytes`, aligned to 64, with anything in them; throws std::bad_alloc. For arrays that will be filled: as
/// little as the first byte may take up a whole large page.
void* allocate_large(std::size_t bytes);
void free_large(void* memory, std::size_t bytes) noexcept;

/// Asks for large pages where `memory`, which some other allocator gave, fills them and is untouched so far.
/// Only a hint, as that may be refused. Most of the bytes are to be written. Memory of the heap stays so
/// after it is freed, for whatever comes to lie there; to spare it would cost a decoder 2 to 4 %, as arrays
/// of many meshes lie there.
void want_large_pages(void* memory, std::size_t bytes) noexcept;

/// Arrays are large from here on; bytes. Small code has one way for all.
inline constexpr std::size_t kLargeArray = std::size_t{1} << 16;
#ifdef DELTAMESH_SMALL
inline constexpr bool kHasLargeArrays = false;
#else
inline constexpr bool kHasLargeArrays = true;
#endif

/// For containers, which ask for no more than can be addressed. An element without a value is
/// default-initialised, which leaves numbers as they are.
template <class T>
class LargeAllocator {
 public:
  using value_type = T;

  LargeAllocator() noexcept = default;
  template <class U>
  // NOLINTNEXTLINE(google-explicit-constructor): as the rules ask
  LargeAllocator(const LargeAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) {
    if (!is_large(count)) return std::allocator<T>{}.allocate(count);
    return static_cast<T*>(allocate_large(count * sizeof(T)));
  }

  void deallocate(T* memory, std::size_t count) noexcept {
    if (!is_large(count)) {
      std::allocator<T>{}.deallocate(memory, count);
    } else {
      free_large(memory, count * sizeof(T));
    }
  }

  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }

  /// Says so where there is nothing to do: GCC 12 would write zeros over vectors of a processor's own kind.
  template <class U>
  void destroy(U* place) noexcept {
    if constexpr (!std::is_trivially_destructible_v<U>) std::destroy_at(place);
  }

  friend bool operator==(const LargeAllocator&, const LargeAllocator&) noexcept { return true; }

 private:
  static bool is_large(std::size_t count) noexcept {
    return kHasLargeArrays && count >= kLargeArray / sizeof(T);
  }
};

/// A vector with such memory. `LargeVector<int>(n)` and resize() leave the elements uninitialised: write each
/// before it is read, or ask for zeros by a second argument.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

/// As reserve(), for a vector that has none of the elements yet, and soon will have most of them.
template <class T>
void reserve_large(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  want_large_pages(values.data(), count * sizeof(T));
}

}  // namespace deltamesh
