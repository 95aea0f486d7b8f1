// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Initial and final models of a coder [CMP-16].
#pragma once

#include <cstdint>

namespace deltamesh {

/// Upper limit of the symbol count of a model that starts from another stream's state, so that it first
/// adapts at a rate of 1/32.
inline constexpr std::uint8_t kMostCountedBefore = 26;  // [CMP-16]

/// `Models`: all that a coder learns. Does not own them.
template <class Models>
struct Learning {
  const Models* start = nullptr;  ///< null: fresh models
  Models* end = nullptr;          ///< where they are wanted after the last symbol
};

}  // namespace deltamesh
