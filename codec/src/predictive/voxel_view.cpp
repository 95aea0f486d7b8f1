// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_view.h"

#include <algorithm>
#include <bit>

namespace deltamesh {
namespace {

using voxel::CubePair;
using voxel::kAllEdges;
using voxel::kNoEdge;

FourInts as_lanes(const voxel::Steps& steps) noexcept { return std::bit_cast<FourInts>(steps); }

EightShorts all_lanes(std::int16_t value) noexcept { return EightShorts{} + value; }

/// By the axis: a lane mask.
constexpr std::array<std::array<std::int16_t, 8>, 3> kAxisLane = {{{-1}, {0, -1}, {0, 0, -1}}};

/// 2^14 over a number.
constexpr std::array<std::int16_t, 2 * Surroundings::kMostKnown + 1> kPartOf = [] {
  std::array<std::int16_t, 2 * Surroundings::kMostKnown + 1> parts{};
  for (std::size_t n = 1; n < parts.size(); ++n) parts[n] = static_cast<std::int16_t>((16384 + n / 2) / n);
  return parts;
}();

const CubePair& pair_of(const VoxelVertex& a, const VoxelVertex& b) noexcept {
  const std::size_t place = index_of_steps(steps_between(a.place, b.place));
  return voxel::kPairTable.pairs[voxel::kPairTable.places[a.axis()][place]];
}

}  // namespace

bool VoxelView::find(const Surroundings& around, std::span<const VoxelVertex> vertices) noexcept {
  for (unsigned i = 0; i < around.known_count; ++i) {
    const KnownFace& face = around.known[i];
    a_ = &vertices[face.a];
    b_ = &vertices[face.b];
    if (!a_->on_edge() || !b_->on_edge()) continue;
    pair_ = &pair_of(*a_, *b_);
    if (pair_->cubes == 0) continue;
    opposite_vertex_ = nullptr;
    if (face.opposite != kNoVertex && vertices[face.opposite].on_edge())
      opposite_vertex_ = &vertices[face.opposite];
    if (pair_->cubes == 1) {
      choose(false);
      return true;
    }
    // The face across is in one of the cubes, so that this one is in the other.
    const std::size_t axis = pair_->axis;
    const std::int32_t between = a_->place[axis] + pair_->centers[0][axis] + 1;
    const std::int32_t side = opposite_vertex_ != nullptr ? opposite_vertex_->place[axis] - between : 0;
    is_open_ = side == 0;
    if (is_open_) opposite_vertex_ = nullptr;
    if (!is_open_) choose(side < 0);
    return true;
  }
  return false;
}

void VoxelView::choose(bool higher) noexcept {
  const std::size_t own = higher ? 1 : 0;
  const std::size_t other = pair_->cubes == 2 ? 1 - own : own;
  center_ = a_->place + as_lanes(pair_->centers[own]);
  turn_ = pair_->turns[own];
  kind_ = pair_->kinds[own];
  if (opposite_vertex_ == nullptr) return;
  const FourInts across = a_->place + as_lanes(pair_->centers[other]);
  opposite_ =
      voxel::kTurned[turn_][voxel::kEdgeAt[index_of_steps(steps_between(across, opposite_vertex_->place))]];
}

bool VoxelView::higher_has(const VoxelVertex& vertex) const noexcept {
  const FourInts center = a_->place + as_lanes(pair_->centers[1]);
  return voxel::kEdgeAt[index_of_steps(steps_between(center, vertex.place))] != kNoEdge;
}

EightShorts VoxelView::place_of(const VoxelVertex& vertex, EightShorts steps) const noexcept {
  const auto lane = std::bit_cast<EightShorts>(kAxisLane[vertex.axis()]);
  return (steps << 6) + (lane & all_lanes(static_cast<std::int16_t>(vertex.along() - kHalf)));
}

void VoxelView::look(const Surroundings& around, std::span<const VoxelVertex> vertices,
                     const BlendTable& blends) noexcept {
  unsigned allowed = kAllEdges;
  unsigned parallelograms = 0;
  EightShorts sum{};
  EightShorts ends{};
  EightShorts corners{};
  const auto visit = [&](const VoxelVertex& vertex) {
    const EightShorts steps = steps_between(center_, vertex.place);
    const unsigned left = allowed & voxel::kEdgesNear[index_of_steps(steps)];
    allowed = left != 0 ? left : allowed;
    return place_of(vertex, steps);
  };
  for (unsigned i = 0; i < around.known_count; ++i) {
    const KnownFace& face = around.known[i];
    const VoxelVertex& a = vertices[face.a];
    const VoxelVertex& b = vertices[face.b];
    if (!a.on_edge() || !b.on_edge()) continue;
    const EightShorts place_a = visit(a);
    const EightShorts both = place_a + visit(b);
    const bool is_repeated = around.repeated[i] != 0;
    sum += is_repeated ? both - place_a : both;
    neighbors_ += is_repeated ? 1 : 2;
    if (face.opposite == kNoVertex || !vertices[face.opposite].on_edge()) continue;
    const VoxelVertex& opposite = vertices[face.opposite];
    ends += both;
    corners += both - place_of(opposite, steps_between(center_, opposite.place));
    ++parallelograms;
  }
  mean_ = mul_high(sum << 2, all_lanes(kPartOf[neighbors_]));
  expected_ = mean_;
  if (parallelograms > 0) {
    const EightShorts part = all_lanes(kPartOf[parallelograms]);
    const Blend& blend = blends[blend_row(around)];
    const EightShorts corner = mul_high(corners << 2, part) - mean_;
    const EightShorts edge = mul_high(ends << 1, part) - mean_;
    expected_ += mul_high(corner << 4, all_lanes(static_cast<std::int16_t>(blend.parallelogram * 64))) +
                 mul_high(edge << 4, all_lanes(static_cast<std::int16_t>(blend.edge * 64)));
  }
  expected_ = lane_max(lane_min(expected_, all_lanes(kFar)), all_lanes(-kFar));
  place_a_ = place_of(*a_, steps_between(center_, a_->place));
  place_b_ = place_of(*b_, steps_between(center_, b_->place));
  likely_ = static_cast<unsigned>(std::popcount(allowed));
  rank(expected_, allowed);
}

/// Half the squared distance of the expected place to every edge, less what all have: by the offsets s of an
/// edge on its two other axes - s place, and on its own how far off its middle counts less than elsewhere.
void VoxelView::rank(EightShorts expected, unsigned allowed) noexcept {
  const EightShorts size = lane_max(expected, -expected);
  const EightShorts inside = lane_min(size, all_lanes(kHalf));
  const EightShorts own = inside - size - ((inside * inside) >> 7);
  constexpr EightShorts kNext = {1, -1, 1, -1, 1, -1, 1, -1};
  constexpr EightShorts kLast = {1, 1, -1, -1, 1, 1, -1, -1};
  const EightShorts low = __builtin_shufflevector(own, own, 0, 0, 0, 0, 1, 1, 1, 1) +
                          __builtin_shufflevector(expected, expected, 1, 1, 1, 1, 2, 2, 2, 2) * kNext +
                          __builtin_shufflevector(expected, expected, 2, 2, 2, 2, 0, 0, 0, 0) * kLast;
  const EightShorts high = __builtin_shufflevector(own, own, 2, 2, 2, 2, 2, 2, 2, 2) +
                           __builtin_shufflevector(expected, expected, 0, 0, 0, 0, 0, 0, 0, 0) * kNext +
                           __builtin_shufflevector(expected, expected, 1, 1, 1, 1, 1, 1, 1, 1) * kLast;
  constexpr EightShorts kBits = {1, 2, 4, 8, 16, 32, 64, 128};
  const auto score = [](EightShorts distance, unsigned set, EightShorts numbers) {
    const EightShorts scores = (distance << 4) + numbers;
    const EightShorts closed = (all_lanes(static_cast<std::int16_t>(set)) & kBits) == 0;
    return (scores & ~closed) | (closed & kClosed);
  };
  const EightShorts scores = score(low, allowed & 0xff, EightShorts{0, 1, 2, 3, 4, 5, 6, 7});
  const EightShorts more = score(high, allowed >> 8, EightShorts{8, 9, 10, 11, 12, 13, 14, 15});
  const std::int16_t best = least(lane_min(scores, more));
  const auto but_best = [best](EightShorts lanes) {
    const EightShorts is_best = lanes == best;
    return (lanes & ~is_best) | (is_best & kClosed);
  };
  const std::int16_t second = least(lane_min(but_best(scores), but_best(more)));
  nearest_ = voxel::kTurned[turn_][best & 15];
  next_ = voxel::kTurned[turn_][second & 15];
}

unsigned VoxelView::number_of(const VoxelVertex& vertex) const noexcept {
  return voxel::kTurned[turn_][voxel::kEdgeAt[index_of_steps(steps_between(center_, vertex.place))]];
}

std::size_t VoxelView::edge_of(unsigned number, VoxelVertex& vertex) const noexcept {
  const unsigned edge = voxel::kBeforeTurn[turn_][number];
  vertex.place = center_ + as_lanes(voxel::kEdgeSteps[edge]);
  return edge / 4;
}

std::int32_t VoxelView::plane_along(std::size_t k, const VoxelVertex& vertex) const noexcept {
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  const EightShorts side = place_b_ - place_a_;
  const EightShorts up = expected_ - place_a_;
  const std::int32_t across = side[i] * up[j] - side[j] * up[i];
  if (across == 0) return mean_along(k);
  const std::int32_t at_i = kHalf * (vertex.place[i] - center_[i]) - place_a_[i];
  const std::int32_t at_j = kHalf * (vertex.place[j] - center_[j]) - place_a_[j];
  const std::int32_t rise =
      (side[j] * up[k] - side[k] * up[j]) * at_i + (side[k] * up[i] - side[i] * up[k]) * at_j;
  return place_a_[k] - rise / across + kHalf;
}

}  // namespace deltamesh
