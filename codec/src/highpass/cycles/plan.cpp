// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/cycles/plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace deltamesh {
namespace {

/// Of the best one's.
constexpr double kFairRms = 1.012;
constexpr double kFairLargest = 1.25;  // one vertex's, by chance
constexpr double kFairRoughness = 1.008;

/// L v at a node.
Vec3 delta_at(const Adjacency& graph, std::span<const Vec3> v, std::uint32_t node) noexcept {
  Vec3 sum{};
  for (const std::uint32_t neighbor : graph.of(node)) sum = sum + v[neighbor];
  return v[node] - (1.0 / graph.degree(node)) * sum;
}

}  // namespace

PlanErrors errors_of(const Adjacency& graph, std::span<const Vec3> errors) {
  double squares = 0;
  double largest = 0;
  double delta_squares = 0;
  for (std::uint32_t node = 0; node < errors.size(); ++node) {
    const double square = dot(errors[node], errors[node]);
    squares += square;
    largest = std::max(largest, square);
    const Vec3 delta = delta_at(graph, errors, node);
    delta_squares += dot(delta, delta);
  }
  const auto count = static_cast<double>(errors.size());
  return {.rms = std::sqrt(squares / count),
          .largest = std::sqrt(largest),
          .roughness = std::sqrt(delta_squares / count)};
}

bool PlanErrors::are_fair(const PlanErrors& best, double invisible) const noexcept {
  const auto is_fair = [&](double own, double other, double most) {
    return own <= invisible || own <= most * other;
  };
  return is_fair(rms, best.rms, kFairRms) && is_fair(largest, best.largest, kFairLargest) &&
         is_fair(roughness, best.roughness, kFairRoughness);
}

FlatDeltas::FlatDeltas(const Adjacency& graph, std::span<const std::int32_t> symbols) : graph_(&graph) {
  const std::size_t count = symbols.size() / 3;
  flat_.resize(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto of_axis = symbols.subspan(axis * count, count);
    for (std::uint32_t node = 0; node < count; ++node) {
      const auto around = graph.of(node);
      const bool is_flat =
          of_axis[node] == 0 && std::all_of(around.begin(), around.end(),
                                            [&](std::uint32_t neighbor) { return of_axis[neighbor] == 0; });
      flat_[node][axis] = is_flat;
    }
  }
}

LeftOut FlatDeltas::left_out(std::span<const Vec3> errors) const {
  double largest = 0;
  double lost_squares = 0;
  for (std::uint32_t node = 0; node < flat_.size(); ++node) {
    largest = std::max(largest, dot(errors[node], errors[node]));
    const Vec3 delta = delta_at(*graph_, errors, node);
    for (std::size_t axis = 0; axis < 3; ++axis)
      lost_squares += flat_[node][axis] ? delta[axis] * delta[axis] : 0;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(flat_.size(), 1));
  return {.largest = std::sqrt(largest), .lost = std::sqrt(lost_squares / count)};
}

}  // namespace deltamesh
