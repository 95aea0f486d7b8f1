// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where the models of a coder begin, and what becomes of them [CMP-16].
#pragma once

#include <cstdint>
#include <utility>

namespace deltamesh {

/// Of the symbols that a starting state was learnt from at most so many count, so that it moves by 1/32 of
/// the way at first.
inline constexpr std::uint8_t kMostCountedBefore = 26;  // [CMP-16]

/// `Models`: all that a coder learns. Does not own them.
template <class Models>
struct Learning {
  const Models* start = nullptr;  ///< null: fresh models
  Models* end = nullptr;          ///< where they are wanted after the last symbol
};

}  // namespace deltamesh
