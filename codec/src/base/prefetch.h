// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Asks for memory before it is needed, where the compiler knows how.
#pragma once

namespace deltamesh {

/// A hint: any address will do.
inline void prefetch([[maybe_unused]] const void* address) noexcept {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace deltamesh
