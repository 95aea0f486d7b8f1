// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How many of the solver's cycles a stream asks its decoders for [DELT-7].
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/vec3.h"
#include "laplacian/solved_part.h"

namespace deltamesh {

/// Half cycles tried before it is left to the decoder to decide.
inline constexpr int kMostPlanned = 16;

/// What the number of cycles depends on, besides the graph.
struct CycleCircumstances {
  double step = 0;
  double diffusion = 0;
  std::size_t anchors = 0;
};

/// The number found last, for as long as circumstances hardly change.
class CyclePlan {
 public:
  std::optional<std::uint8_t> half_cycles_for(const CycleCircumstances& now) const noexcept;
  void keep(const CycleCircumstances& now, std::uint8_t half_cycles) noexcept;

 private:
  CycleCircumstances found_for_;
  std::optional<std::uint8_t> half_cycles_;
};

/// Whether `solution` may stand for `settled`, where the solver decided itself when to stop: how far both are
/// from `positions` hardly differs, rms and at most, nor do their delta coordinates, nor are they far apart.
/// Over the rows of `part`; all spans: one entry for each vertex of the whole graph. `invisible`: model units
/// that nobody would see. O(n).
bool is_as_good(const SolvedPart& part, std::span<const Vec3> positions, std::span<const Vec3> settled,
                std::span<const Vec3> solution, double invisible);

}  // namespace deltamesh
