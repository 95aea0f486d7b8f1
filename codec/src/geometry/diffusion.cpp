// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/diffusion.h"

#include "geometry/delta_pass.h"
#include "geometry/frugal_symbols.h"

namespace deltamesh {
namespace {

constexpr Error kStepTooSmall{.code = ErrorCode::kInvalidArgument,
                              .message = "the step is too small for this mesh: deltas exceed 2^30 steps"};

}  // namespace

Result<std::vector<std::int32_t>> quantize_deltas(const Adjacency& graph, std::span<const Vec3> deltas,
                                                  const DeltaQuantizer& quantizer, double strength,
                                                  double rate_weight) {
  const std::size_t count = deltas.size();
  std::vector<std::int32_t> symbols(3 * count);
  const auto store = [&](std::uint32_t i, const std::array<std::int32_t, 3>& q) {
    for (std::size_t axis = 0; axis < 3; ++axis) symbols[axis * count + i] = q[axis];
    return q;
  };
  const auto take_nearest = [&](std::uint32_t i, const std::array<std::int32_t, 3>& nearest, const Vec3&) {
    return store(i, nearest);
  };
  if (!(rate_weight > 0)) {
    if (!pass_over_deltas(graph, deltas, quantizer, strength, take_nearest)) return kStepTooSmall;
    return symbols;
  }
  FrugalSymbols frugal(graph, quantizer, rate_weight);
  const auto take_frugal = [&](std::uint32_t i, const std::array<std::int32_t, 3>& nearest,
                               const Vec3& target) { return store(i, frugal.choose(i, nearest, target)); };
  if (!pass_over_deltas(graph, deltas, quantizer, strength, take_frugal)) return kStepTooSmall;
  return symbols;
}

}  // namespace deltamesh
