// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The cube that a vertex's first usable face puts it in, and what the vertices around say of where in it
// [VOX-2, VOX-3]. Integers only; shared by writer and reader.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "predictive/blend.h"
#include "predictive/voxel_edges.h"
#include "predictive/voxel_lanes.h"
#include "predictive/voxel_tables.h"

namespace deltamesh {

namespace voxel {

inline constexpr EightShorts kNodes = {-kVoxelParts, -kVoxelParts, -kVoxelParts,
                                       0};  ///< bits of a spot's node

/// 2^14 over a number, in all lanes.
inline constexpr auto kPartOf = [] {
  std::array<std::array<std::int16_t, 8>, 2 * Surroundings::kMostKnown + 1> parts{};
  for (std::size_t n = 1; n < parts.size(); ++n)
    parts[n].fill(static_cast<std::int16_t>((16384 + n / 2) / n));
  return parts;
}();

/// By near_index(): `spot` is from the cube's lowest node, and cut as from_lowest() cuts it.
[[gnu::always_inline]] inline std::size_t place_near(EightShorts spot) noexcept {
  return static_cast<std::size_t>(weigh(spot >> kVoxelBits, kNearWeights) + kNearMiddle);
}

[[gnu::always_inline]] inline EightShorts cut(EightShorts from_lowest) noexcept {
  return clamp(from_lowest, -kBelow * kVoxelParts, kAbove * kVoxelParts);
}

/// `a_node`: of the edge `a`.
[[gnu::always_inline]] inline const CubePair& pair_of(const VoxelSpot& a, EightShorts a_node,
                                                      EightShorts b) noexcept {
  const EightShorts apart = clamp(wrapped_difference(b, a_node) >> kVoxelBits, -kMostApart, kMostApart);
  const auto place = static_cast<std::size_t>(weigh(apart, kPairWeights) + kPairMiddle);
  const auto axis = static_cast<std::size_t>(a.at[3] >> kVoxelBits);
  return kPairTable.pairs[kPairTable.places[axis][place]];
}

[[gnu::always_inline]] inline EightShorts size_of(EightShorts lanes) noexcept {
  const EightShorts sign = lanes >> 15;
  return (lanes ^ sign) - sign;
}

/// How many are in a set of twelve.
inline constexpr std::array<std::uint8_t, kAllEdges + 1> kCounts = [] {
  std::array<std::uint8_t, kAllEdges + 1> counts{};
  for (unsigned set = 1; set < counts.size(); ++set)
    counts[set] = static_cast<std::uint8_t>(counts[set / 2] + set % 2);
  return counts;
}();

}  // namespace voxel

/// Edges are told by their numbers after the cube's turn. find(), then choose() where is_open(), then look();
/// what the others tell is known after these.
class VoxelView {
 public:
  /// False where no known face has a cube. `spots`: of the vertices before this one at least.
  bool find(const Surroundings& around, std::span<const VoxelSpot> spots) noexcept;

  /// The vertex may be in two cubes.
  bool is_open() const noexcept { return is_open_; }
  void choose(bool higher) noexcept { cube_ = &pair_->cubes[higher ? 1 : 0]; }
  /// Whether the higher one of two cubes has the edge at a spot.
  bool higher_has(const VoxelSpot& spot) const noexcept;

  /// As given to find().
  void look(const Surroundings& around, std::span<const VoxelSpot> spots, const BlendTable& blends) noexcept;

  /// voxel::kNoEdge where the cube does not have it.
  unsigned number_of(const VoxelSpot& spot) const noexcept;
  /// The edge of this number, below 12.
  unsigned edge_of(unsigned number) const noexcept { return voxel::kBeforeTurn[cube_->turn][number]; }
  /// A spot on it, at this part.
  VoxelSpot spot_on(unsigned edge, std::int16_t part) const noexcept;
  /// From the node of the face's corner a to the edge's, and 0.
  FourInts steps_to(unsigned edge) const noexcept;

  std::uint32_t corner() const noexcept { return corner_; }  ///< the face's corner a
  unsigned kind() const noexcept { return cube_->kind; }     ///< how the face's corners lie, below 6
  unsigned opposite() const noexcept { return opposite_; }   ///< where the face's opposite is in its cube
  unsigned nearest() const noexcept { return nearest_; }     ///< to where the vertex is expected
  unsigned next() const noexcept { return next_; }           ///< after it, or kNoEdge
  unsigned likely() const noexcept { return likely_; }       ///< how many edges the vertices around allow

  /// Where on an edge the neighbours' mean is, from its lower end, parts of a voxel.
  std::int32_t mean_on(unsigned edge) const noexcept { return mean_[edge / 4] + kVoxelMiddle; }
  /// Where the plane through the face's corners and the expected spot cuts it, likewise.
  std::int32_t plane_on(unsigned edge) const noexcept;

 private:
  static constexpr std::int16_t kFar =
      3 * kVoxelMiddle;  ///< from the centre: nothing is expected farther off

  struct Seen;
  EightShorts from_lowest(const VoxelSpot& spot) const noexcept;
  void add(EightShorts a, EightShorts b, std::int32_t repeated, const KnownFace& face,
           std::span<const VoxelSpot> spots, Seen& seen) noexcept;
  EightShorts blend(const Seen& seen, const Surroundings& around, const BlendTable& blends) noexcept;

  const voxel::CubePair* pair_ = nullptr;
  const voxel::PairCube* cube_ = nullptr;
  std::uint32_t corner_ = 0;
  std::uint32_t face_ = 0;  ///< of the known ones
  bool is_open_ = false;
  unsigned opposite_ = voxel::kNoEdge;
  unsigned nearest_ = 0;
  unsigned next_ = 0;
  unsigned likely_ = 0;
  unsigned neighbors_ = 0;
  EightShorts node_{};    ///< of the face's corner a, as a spot
  EightShorts lowest_{};  ///< the cube's lowest node, likewise
  EightShorts mean_{};    ///< from the cube's centre, parts of a voxel
  EightShorts corner_spot_{};
  FourInts normal_{};
};

/// What was summed up, from the cube's centre.
struct VoxelView::Seen {
  EightShorts corners;  ///< of neighbours
  EightShorts ends;     ///< a + b of parallelograms
  EightShorts meets;    ///< a + b - o
  unsigned parallelograms;
};

[[gnu::always_inline]] inline bool VoxelView::find(const Surroundings& around,
                                                   std::span<const VoxelSpot> spots) noexcept {
  for (face_ = 0; face_ < around.known_count; ++face_) {
    const KnownFace& face = around.known[face_];
    const VoxelSpot& a = spots[face.a];
    const VoxelSpot& b = spots[face.b];
    if (!a.on_edge() || !b.on_edge()) continue;
    corner_ = face.a;
    node_ = load(a.at) & voxel::kNodes;
    pair_ = &voxel::pair_of(a, node_, load(b.at));
    if (pair_->count == 0) continue;
    is_open_ = pair_->count == 2;
    choose(false);
    if (face.opposite == kNoVertex || !spots[face.opposite].on_edge()) return true;
    // The face across is in one of the cubes, so that this one is in the other.
    const VoxelSpot& opposite = spots[face.opposite];
    const std::size_t axis = pair_->axis;
    const auto side = static_cast<std::int16_t>(opposite.at[axis] - (a.at[axis] & -kVoxelParts) -
                                                pair_->cubes[0].lowest[axis] - kVoxelParts);
    is_open_ = is_open_ && side == 0;
    if (is_open_) return true;
    choose(side < 0);
    const voxel::PairCube& across = pair_->cubes[side < 0 ? 0 : 1];
    const EightShorts from_lowest =
        voxel::cut(wrapped_difference(load(opposite.at), wrapped_sum(node_, load(across.lowest))));
    opposite_ = voxel::kTurned[cube_->turn][voxel::kEdgeAt[voxel::place_near(from_lowest)]];
    return true;
  }
  return false;
}

inline bool VoxelView::higher_has(const VoxelSpot& spot) const noexcept {
  const EightShorts from_lowest =
      voxel::cut(wrapped_difference(load(spot.at), wrapped_sum(node_, load(pair_->cubes[1].lowest))));
  return voxel::kEdgeAt[voxel::place_near(from_lowest)] != voxel::kNoEdge;
}

[[gnu::always_inline]] inline EightShorts VoxelView::from_lowest(const VoxelSpot& spot) const noexcept {
  return voxel::cut(wrapped_difference(load(spot.at), lowest_));
}

/// A face with the corners `a` and `b`, of which a is not counted where `repeated` is -1.
[[gnu::always_inline]] inline void VoxelView::add(EightShorts a, EightShorts b, std::int32_t repeated,
                                                  const KnownFace& face, std::span<const VoxelSpot> spots,
                                                  Seen& seen) noexcept {
  const EightShorts both = a + b;
  seen.corners += both - (a & all_lanes(static_cast<std::int16_t>(repeated)));
  neighbors_ += static_cast<unsigned>(2 + repeated);
  if (face.opposite == kNoVertex || !spots[face.opposite].on_edge()) return;
  seen.ends += both;
  seen.meets += both - (from_lowest(spots[face.opposite]) - kVoxelMiddle);
  ++seen.parallelograms;
}

[[gnu::always_inline]] inline void VoxelView::look(const Surroundings& around,
                                                   std::span<const VoxelSpot> spots,
                                                   const BlendTable& blends) noexcept {
  lowest_ = wrapped_sum(node_, load(cube_->lowest));
  unsigned likely = cube_->others;
  const KnownFace& first = around.known[face_];
  const EightShorts first_a = wrapped_difference(load(spots[first.a].at), lowest_) - kVoxelMiddle;
  const EightShorts first_b = wrapped_difference(load(spots[first.b].at), lowest_) - kVoxelMiddle;
  Seen seen{};
  add(first_a, first_b, around.repeated[static_cast<int>(face_)], first, spots, seen);
  for (unsigned i = face_ + 1; i < around.known_count; ++i) {
    const KnownFace& face = around.known[i];
    if (!spots[face.a].on_edge() || !spots[face.b].on_edge()) continue;
    const EightShorts a = from_lowest(spots[face.a]);
    const EightShorts b = from_lowest(spots[face.b]);
    const unsigned by_a = likely & voxel::kEdgesNear[voxel::place_near(a)];
    likely = by_a != 0 ? by_a : likely;
    const unsigned by_b = likely & voxel::kEdgesNear[voxel::place_near(b)];
    likely = by_b != 0 ? by_b : likely;
    add(a - kVoxelMiddle, b - kVoxelMiddle, around.repeated[static_cast<int>(i)], face, spots, seen);
  }
  const EightShorts expected = blend(seen, around, blends);
  normal_ = cross(first_b - first_a, expected - first_a);
  corner_spot_ = first_a;
  likely_ = voxel::kCounts[likely];
  // In half parts, which bytes hold.
  const EightShorts spot = clamp(expected, -kVoxelParts + 1, kVoxelParts - 1);
  const EightShorts size = voxel::size_of(spot);
  const EightShorts inside = clamp(size, 0, kVoxelMiddle);
  const EightShorts own = inside - size - ((inside * inside) >> kVoxelBits);
  const NearestEdges edges = nearest_edges(spot >> 1, own >> 1, likely);
  nearest_ = voxel::kTurned[cube_->turn][edges.nearest];
  next_ = voxel::kTurned[cube_->turn][edges.next];
}

/// Sums of up to eight spots times 4, and differences of means times 16, are within 16 bits.
[[gnu::always_inline]] inline EightShorts VoxelView::blend(const Seen& seen, const Surroundings& around,
                                                           const BlendTable& blends) noexcept {
  mean_ = mul_high(seen.corners << 2, std::bit_cast<EightShorts>(voxel::kPartOf[neighbors_]));
  EightShorts expected = mean_;
  if (seen.parallelograms > 0) {
    const EightShorts part = std::bit_cast<EightShorts>(voxel::kPartOf[seen.parallelograms]);
    const Blend& blend = blends[blend_row(around)];
    const EightShorts meet = mul_high(seen.meets << 2, part) - mean_;
    const EightShorts edge = mul_high(seen.ends << 1, part) - mean_;
    // Weights count 1/64; the high half of 16 x 64 times as much is that.
    constexpr std::int16_t kTimes = 64;
    expected += mul_high(meet << 4, all_lanes(static_cast<std::int16_t>(blend.parallelogram * kTimes))) +
                mul_high(edge << 4, all_lanes(static_cast<std::int16_t>(blend.edge * kTimes)));
  }
  return clamp(expected, -kFar, kFar);
}

inline unsigned VoxelView::number_of(const VoxelSpot& spot) const noexcept {
  return voxel::kTurned[cube_->turn][voxel::kEdgeAt[voxel::place_near(from_lowest(spot))]];
}

inline VoxelSpot VoxelView::spot_on(unsigned edge, std::int16_t part) const noexcept {
  static constexpr std::array<FourShorts, 3> kAxes = {{{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}};
  const EightShorts along = all_lanes(part) & load(kAxes[edge / 4]);
  return {store(wrapped_sum(lowest_, load(voxel::kEdgeSpots[edge]) + along))};
}

inline FourInts VoxelView::steps_to(unsigned edge) const noexcept {
  return widen(((load(cube_->lowest) + load(voxel::kEdgeSpots[edge])) & voxel::kNodes) >> kVoxelBits);
}

inline std::int32_t VoxelView::plane_on(unsigned edge) const noexcept {
  const std::size_t axis = edge / 4;
  const std::int32_t steep = normal_[axis];
  if (steep == 0) return mean_on(edge);
  const FourShorts& node = voxel::kEdgeSpots[edge];
  std::int32_t rise = 0;
  for (std::size_t a = 0; a < 3; ++a)
    rise += normal_[a] * ((a == axis ? 0 : node[a] - kVoxelMiddle) - corner_spot_[a]);
  return kVoxelMiddle - rise / steep;
}

}  // namespace deltamesh
