// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The place of the highest bit, without the test for 0 that the standard's functions make.
#pragma once

#include <cstdint>

namespace deltamesh {

/// `x`: above 0.
constexpr unsigned floor_log2(std::uint64_t x) noexcept {
  return 63U ^ static_cast<unsigned>(__builtin_clzll(x));
}

}  // namespace deltamesh
