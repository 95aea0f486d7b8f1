// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A request as rate control gets it.
#pragma once

#include <cstdint>
#include <optional>

#include "search/bounds.h"

namespace deltamesh {

/// Up to here one pass is made, and no search.
inline constexpr int kOnePassEffort = 1;

/// A request, in model units, with what else the caller has fixed. Without bounds and target, both step and
/// anchors are.
struct RateGoal {
  Bounds bounds{};
  std::optional<std::uint64_t> target_bytes = std::nullopt;
  std::optional<double> step = std::nullopt;            ///< fixed: only anchors and diffusion may move
  std::optional<std::uint32_t> anchors = std::nullopt;  ///< fixed number in the solved components
  int anchor_bits = 12;  ///< at first: more for tight bounds, down to 4 where bounds leave room
  int effort = 5;        ///< 0 to 9
  /// Size of another coder's stream that keeps the request: what stays far above it is not refined further,
  /// or not even tried.
  std::optional<std::uint64_t> rival_bytes = std::nullopt;

  /// Whether `bytes` is more than `share` times the rival's.
  bool loses(std::uint64_t bytes, double share) const noexcept {
    return rival_bytes && static_cast<double>(bytes) > share * static_cast<double>(*rival_bytes);
  }
};

}  // namespace deltamesh
