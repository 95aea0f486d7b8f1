// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Gluing of meshes with many glued vertices by the compact coder: guesses from faces that share the gate's
// edge [CONN-14]. Two-sided sheets and doubled faces then cost next to nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/zigzag.h"
#include "base/small_code.h"
#include "connectivity/faces/cut.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// From this share of glued vertices on they are coded one by one [CONN-14].
inline constexpr std::uint64_t kDenseShare = 16;
constexpr bool is_dense(std::uint64_t glued, std::uint64_t manifold_count) noexcept {
  return glued * kDenseShare > manifold_count;
}

/// The faces at every directed edge, over vertices of the mesh. The first faces at a vertex are a list; a
/// stream can give a vertex any number, so that the others are in a tree, which costs more.
class EdgeApexes {
 public:
  /// Never more than so many vertices and edges.
  EdgeApexes(std::size_t vertices, std::size_t edges) {
    heads_.reserve(vertices);
    listed_.reserve(edges);
  }

  /// Apexes that the face across a gate may have if it duplicates an earlier face.
  struct Guesses {
    std::uint32_t same = kNoIndex;      ///< apex of the first face with the edge in the same direction
    std::uint32_t mirrored = kNoIndex;  ///< of the first of two or more with the opposite direction
  };

  Guesses guess(std::uint32_t from, std::uint32_t to) const {
    const Edge opposite = find(to, from);
    return {.same = find(from, to).apex, .mirrored = opposite.faces > 1 ? opposite.apex : kNoIndex};
  }

  void add(const std::array<std::uint32_t, 3>& face) {
    for (std::size_t k = 0; k < 3; ++k) add(face[k], face[(k + 1) % 3], face[(k + 2) % 3]);
  }

 private:
  static constexpr unsigned kMostListed = 24;
  struct Edge {
    std::uint32_t apex = kNoIndex;  ///< of the first face
    std::uint32_t faces = 0;
  };
  struct Listed {
    std::uint32_t to;
    std::uint32_t apex;
    std::uint32_t before;  ///< that of the same vertex
  };
  struct Head {
    std::uint32_t last = kNoIndex;
    std::uint32_t count = 0;
  };

  static std::uint64_t key(std::uint32_t from, std::uint32_t to) noexcept {
    return std::uint64_t{from} << 32 | to;
  }

  Edge find(std::uint32_t from, std::uint32_t to) const {
    Edge edge;
    if (from >= heads_.size()) return edge;
    const Head& head = heads_[from];
    if (head.count == kMostListed) {
      const auto it = more_.find(key(from, to));
      if (it != more_.end()) edge = it->second;
    }
    for (std::uint32_t i = head.last; i != kNoIndex; i = listed_[i].before) {
      if (listed_[i].to != to) continue;
      edge.apex = listed_[i].apex;
      ++edge.faces;
    }
    return edge;
  }

  void add(std::uint32_t from, std::uint32_t to, std::uint32_t apex) {
    if (from >= heads_.size()) heads_.resize(std::size_t{from} + 1, Head{});
    Head& head = heads_[from];
    if (head.count == kMostListed) {
      Edge& edge = more_[key(from, to)];
      if (edge.faces++ == 0) edge.apex = apex;
      return;
    }
    ++head.count;
    listed_.push_back({.to = to, .apex = apex, .before = head.last});
    head.last = static_cast<std::uint32_t>(listed_.size() - 1);
  }

  LargeVector<Head> heads_;  ///< of every vertex up to the last that came
  LargeVector<Listed> listed_;
  std::map<std::uint64_t, Edge> more_;  ///< a stream could make the edges of a hash table collide
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class GlueCoder {
 public:
  /// For `faces`, three of `manifold_count` manifold vertices each.
  GlueCoder(Coder& coder, std::span<const std::uint32_t> faces, std::size_t manifold_count)
      : coder_(coder), faces_(faces), edges_(manifold_count, faces.size()) {
    glued_.reserve(manifold_count);
  }

  /// Codes vertex of the mesh for every manifold vertex, where the faces bring them in. `vertex`: one per
  /// manifold vertex; read by a writer, filled in by a reader. False where a target is not there yet, or
  /// `stop`. Once. O(faces log faces).
  template <class Stop>
  bool code(std::span<std::uint32_t> vertex, Stop stop) {
    for (std::size_t f = 0; f < faces_.size(); f += 3)
      if (!code_face(faces_.subspan(f, 3), vertex, stop)) return false;
    return true;
  }

  std::uint32_t glued_count() const noexcept { return static_cast<std::uint32_t>(glued_.size()) - fresh_; }

 private:
  template <class Stop>
  DELTAMESH_LOOP_BODY bool code_face(std::span<const std::uint32_t> corners, std::span<std::uint32_t> vertex,
                                     Stop stop) {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t manifold = corners[k];
      if (manifold == glued_.size()) {
        const auto guesses = k == 2 ? edges_.guess(face[0], face[1]) : EdgeApexes::Guesses{};
        const unsigned glued_ends = k == 2 ? glued_[corners[0]] + glued_[corners[1]] : 0U;
        if (!code_vertex(vertex[manifold], guesses, glued_ends) || stop()) return false;
      }
      face[k] = vertex[manifold];
    }
    edges_.add(face);
    return true;
  }

  bool code_vertex(std::uint32_t& vertex, const EdgeApexes::Guesses& guesses, unsigned glued_ends) {
    const unsigned known = (guesses.same != kNoIndex ? 1U : 0U) + (guesses.mirrored != kNoIndex ? 2U : 0U);
    const bool glued = coder_.bit(vertex != fresh_, is_glued_[glued_ends * 4 + known]);
    glued_.push_back(glued ? 1 : 0);
    if (!glued) {
      vertex = fresh_++;
      return true;
    }
    const unsigned hint = vertex == guesses.same ? 0 : vertex == guesses.mirrored ? 1 : 2;
    const unsigned choice = coder_.symbol(hint, Mixture<1>{{&hints_[known]}});
    if (choice == 0) vertex = guesses.same;
    if (choice == 1) vertex = guesses.mirrored;
    if (choice == 2) {
      const std::uint32_t step =
          coder_.number(zigzag(static_cast<std::int32_t>(vertex - last_target_)), steps_);
      vertex = last_target_ + static_cast<std::uint32_t>(unzigzag(step));
    }
    last_target_ = vertex;
    return choice <= 2 && vertex < fresh_;
  }

  static constexpr SymbolModel kFresh{{4, 4, 4, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  Coder& coder_;
  std::span<const std::uint32_t> faces_;
  EdgeApexes edges_;
  std::vector<std::uint8_t> glued_;  ///< of every manifold vertex so far
  std::uint32_t fresh_ = 0;
  std::uint32_t last_target_ = 0;
  std::array<BitModel, 12> is_glued_;
  std::array<SymbolModel, 4> hints_ = {kFresh, kFresh, kFresh, kFresh};
  NumberModel steps_;
};

}  // namespace deltamesh
