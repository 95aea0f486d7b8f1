// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Memory on large pages, where the system has such: far fewer of them are to be handed out.
#pragma once

#include <cstddef>

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

}  // namespace deltamesh
