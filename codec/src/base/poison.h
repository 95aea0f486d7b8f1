// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tells AddressSanitizer, where a build has it, which memory may be touched: it cannot know of what is handed
// out in parts.
#pragma once

#include <cstddef>

#if __has_include(<sanitizer/asan_interface.h>)
#include <sanitizer/asan_interface.h>
#endif

namespace deltamesh {

#if defined(ASAN_POISON_MEMORY_REGION)
inline void forbid_memory(const void* begin, std::size_t bytes) noexcept {
  ASAN_POISON_MEMORY_REGION(begin, bytes);
}
inline void allow_memory(const void* begin, std::size_t bytes) noexcept {
  ASAN_UNPOISON_MEMORY_REGION(begin, bytes);
}
#else
inline void forbid_memory(const void*, std::size_t) noexcept {}
inline void allow_memory(const void*, std::size_t) noexcept {}
#endif

}  // namespace deltamesh
