// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A coder for as long as a vertex is coded.
#pragma once

#include <type_traits>

namespace deltamesh {

/// Loops have a copy of a reader, whose functions are inlined: a compiler can keep it in registers.
template <class Coder>
inline constexpr bool kHoldsCopy = !Coder::kWrites;

template <class Coder>
using Held = std::conditional_t<kHoldsCopy<Coder>, Coder, Coder&>;

/// Afterwards `coder` is where `held` is.
template <class Coder>
[[gnu::always_inline]] inline void write_back(const Coder& held, Coder& coder) noexcept {
  if constexpr (kHoldsCopy<Coder>) coder = held;
}

}  // namespace deltamesh
