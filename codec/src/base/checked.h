// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Size arithmetic that cannot wrap.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace deltamesh {

/// a * b, or the largest value where that does not fit.
constexpr std::uint64_t saturating_mul(std::uint64_t a, std::uint64_t b) noexcept {
  std::uint64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<std::uint64_t>::max() : product;
}

/// a + b, or the largest value where that does not fit.
constexpr std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) noexcept {
  std::uint64_t sum = 0;
  return __builtin_add_overflow(a, b, &sum) ? std::numeric_limits<std::uint64_t>::max() : sum;
}

/// `count`, or where memory cannot hold as many the largest size, which containers refuse.
constexpr std::size_t memory_size(std::uint64_t count) noexcept {
  return static_cast<std::size_t>(std::min<std::uint64_t>(count, std::numeric_limits<std::size_t>::max()));
}

}  // namespace deltamesh
