// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codes which faces of a base stay, and which vertices of the inserted mesh are joined to vertices of these
// [MAP-17]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/numbers/vec3.h"
#include "base/numbers/zigzag.h"
#include "deltamesh/mesh.h"
#include "entropy/coder/counted_bit.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"
#include "support/face_neighbors.h"
#include "support/open_edges.h"

namespace deltamesh {

inline constexpr std::uint32_t kNotJoined = std::numeric_limits<std::uint32_t>::max();

struct PatchModels {
  /// Most faces do as their neighbours, and most twins are joined.
  PatchModels() {
    for (std::size_t stay = 0; stay < 4; ++stay)
      for (std::size_t go = 0; go < 4; ++go)
        stays[4 * stay + go].fill(CountedBit(stay == go ? 1U << 15 : stay > go ? 15U << 12 : 1U << 12));
  }

  /// By how many of a face's earlier neighbours stay, and how many go, and whether the face before stays.
  std::array<std::array<CountedBit, 2>, 16> stays;
  CountedBit is_twin{15U << 12};
  std::array<BitModel, 6> joins;  ///< by earlier neighbours: 1 if one is not joined, plus 2 for each that is
  NumberModel candidates;
  NumberModel places;
};

/// `stays`: for every face of `base`, 1 or 0; a reader fills it in.
template <class Coder>
void code_staying(Coder& coder, PatchModels& models, const Mesh& base, std::vector<std::uint8_t>& stays) {
  const auto neighbors = earlier_neighbors(base.triangles, base.vertex_count());
  stays.resize(neighbors.size());
  std::size_t before = 1;
  for (std::size_t face = 0; face < neighbors.size(); ++face) {
    std::size_t stay = 0;
    std::size_t go = 0;
    for (const std::uint32_t other : neighbors[face])
      if (other != kNoFace) ++(stays[other] != 0 ? stay : go);
    before = coder.bit(Coder::kWrites && stays[face] != 0, models.stays[4 * stay + go][before]) ? 1 : 0;
    stays[face] = static_cast<std::uint8_t>(before);
  }
}

/// Joins the vertices of an inserted mesh to those of the base's staying faces, both on open edges.
template <class Coder>
class JoinCoder {
 public:
  /// `staying`: triangles of `base`. All arguments must outlive the coder.
  JoinCoder(Coder& coder, PatchModels& models, const Mesh& base, std::span<const std::uint32_t> staying,
            const Mesh& inserted)
      : coder_(coder),
        models_(models),
        base_(base),
        inserted_(inserted),
        base_edges_(staying, base.vertex_count()),
        inserted_edges_(inserted.triangles, inserted.vertex_count()),
        is_taken_(base.vertex_count(), 0),
        place_(base.vertex_count(), 0) {
    for (std::uint32_t v = 0; v < base.vertex_count(); ++v)
      if (!base_edges_.of(v).empty()) open_.push_back(v);
    std::ranges::stable_sort(open_, {}, [&](std::uint32_t v) { return place_of(base_, v); });
    for (std::size_t i = 0; i < open_.size(); ++i) place_[open_[i]] = static_cast<std::uint32_t>(i);
  }

  /// `joins`: for every inserted vertex the base's, or kNotJoined; a reader fills it in. False where there is
  /// no such vertex.
  bool code(std::vector<std::uint32_t>& joins) {
    joins.resize(inserted_.vertex_count(), kNotJoined);
    for (std::uint32_t v = 0; v < joins.size(); ++v) {
      const auto neighbors = inserted_edges_.of(v);
      if (neighbors.empty()) continue;
      if (const std::uint32_t twin = twin_of(v); twin != kNotJoined) {
        if (coder_.bit(Coder::kWrites && joins[v] == twin, models_.is_twin)) {
          joins[v] = twin;
          is_taken_[twin] = 1;
          continue;
        }
      }
      const auto [context, before] = look_around(neighbors, v, joins);
      if (!coder_.bit(Coder::kWrites && joins[v] != kNotJoined, models_.joins[context])) continue;
      if (!code_vertex(v, before, joins[v]) || is_taken_[joins[v]] != 0) return false;
      is_taken_[joins[v]] = 1;
    }
    return true;
  }

 private:
  static constexpr std::size_t kMostCandidates = 4;

  using Place = std::array<float, 3>;
  static Place place_of(const Mesh& mesh, std::uint32_t vertex) noexcept {
    const float* const at = &mesh.positions[3 * std::size_t{vertex}];
    return {at[0], at[1], at[2]};
  }

  /// The first of the base's vertices where the inserted `vertex` is, if none is joined to it yet.
  std::uint32_t twin_of(std::uint32_t vertex) const noexcept {
    const Place place = place_of(inserted_, vertex);
    const auto twin =
        std::ranges::lower_bound(open_, place, {}, [&](std::uint32_t v) { return place_of(base_, v); });
    const bool is_free = twin != open_.end() && is_taken_[*twin] == 0 && place_of(base_, *twin) == place;
    return is_free ? *twin : kNotJoined;
  }

  static std::pair<std::size_t, std::uint32_t> look_around(std::span<const std::uint32_t> neighbors,
                                                           std::uint32_t vertex,
                                                           const std::vector<std::uint32_t>& joins) noexcept {
    std::size_t on = 0;
    std::size_t off = 0;
    std::uint32_t before = kNotJoined;
    for (const std::uint32_t other : neighbors) {
      if (other >= vertex) continue;
      if (joins[other] == kNotJoined) {
        off = 1;
      } else {
        on = std::min<std::size_t>(on + 1, 2);
        before = joins[other];
      }
    }
    return {off + 2 * on, before};
  }

  bool code_vertex(std::uint32_t vertex, std::uint32_t before, std::uint32_t& join) {
    const auto candidates = candidates_near(vertex, before);
    if (!candidates.empty()) {
      const auto found = std::ranges::find(candidates, join);
      const std::uint32_t number =
          coder_.number(static_cast<std::uint32_t>(found - candidates.begin()), models_.candidates);
      if (number > candidates.size()) return false;
      if (number < candidates.size()) {
        join = candidates[number];
        return true;
      }
    }
    const float x = inserted_.positions[3 * std::size_t{vertex}];
    const auto expected = static_cast<std::int32_t>(
        std::ranges::lower_bound(open_, x, {}, [&](std::uint32_t v) { return place_of(base_, v)[0]; }) -
        open_.begin());
    const std::int32_t way =
        Coder::kWrites && !open_.empty() ? static_cast<std::int32_t>(place_[join]) - expected : 0;
    const std::int64_t place = std::int64_t{expected} + unzigzag(coder_.number(zigzag(way), models_.places));
    if (place < 0 || place >= static_cast<std::int64_t>(open_.size())) return false;
    join = open_[static_cast<std::size_t>(place)];
    return true;
  }

  /// The first neighbours of the base's vertex `before` along open edges that no vertex is joined to, nearest
  /// first.
  std::vector<std::uint32_t> candidates_near(std::uint32_t vertex, std::uint32_t before) const {
    std::vector<std::uint32_t> candidates;
    if (before == kNotJoined) return candidates;
    const auto neighbors = base_edges_.of(before);
    for (const std::uint32_t other : neighbors.first(std::min(neighbors.size(), kMostCandidates)))
      if (is_taken_[other] == 0) candidates.push_back(other);
    const float* const place = inserted_.positions.data() + 3 * std::size_t{vertex};
    std::ranges::stable_sort(candidates, {}, [&](std::uint32_t v) {
      return squared_distance(place, base_.positions.data() + 3 * std::size_t{v});
    });
    return candidates;
  }

  Coder& coder_;
  PatchModels& models_;
  const Mesh& base_;
  const Mesh& inserted_;
  OpenEdges base_edges_;
  OpenEdges inserted_edges_;
  std::vector<std::uint8_t> is_taken_;
  std::vector<std::uint32_t> open_;   ///< the base's vertices on open edges of staying faces, by place
  std::vector<std::uint32_t> place_;  ///< of each in open_
};

}  // namespace deltamesh
