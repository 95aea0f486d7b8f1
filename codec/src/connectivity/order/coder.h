// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The original order by the compact coder: places follow from those of neighbours [ORDR-4 .. 6].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/numbers/zigzag.h"
#include "connectivity/faces/cut.h"
#include "connectivity/order/order.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// Memory: 4 bytes per vertex and 12 per face.
class CornerChains {
 public:
  /// `triangles`: m x 3, must outlive this.
  CornerChains(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : triangles_(triangles), newest_(vertex_count, kNoIndex), older_(triangles.size(), kNoIndex) {}

  void add(std::uint32_t face) noexcept {
    for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
      older_[corner] = newest_[triangles_[corner]];
      newest_[triangles_[corner]] = corner;
    }
  }

  /// The newest corner at `from` whose face goes on to `to`, among the kMostSteps newest there.
  std::optional<std::uint32_t> find(std::uint32_t from, std::uint32_t to) const noexcept {
    std::uint32_t corner = newest_[from];
    for (unsigned step = 0; step < kMostSteps && corner != kNoIndex; ++step) {
      if (triangles_[next_in_face(corner)] == to) return corner;
      corner = older_[corner];
    }
    return std::nullopt;
  }

 private:
  static constexpr unsigned kMostSteps = 16;

  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> newest_;  ///< per vertex
  std::vector<std::uint32_t> older_;   ///< per corner
};

/// Places of one kind, each near one of `kGuesses` guesses: the one that was nearest of late [ORDR-4].
template <class Coder, std::size_t kGuesses>
class PlaceCoder {
 public:
  using Guesses = std::array<std::uint32_t, kGuesses>;

  explicit PlaceCoder(Coder& coder) : coder_(coder) {}

  /// Codes `place`; a reader's may be any.
  void code(std::uint32_t& place, const Guesses& guesses) {
    const auto best = static_cast<std::size_t>(std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
    const std::uint32_t step = coder_.number(distance(place, guesses[best]), steps_[last_length_]);
    place = guesses[best] + static_cast<std::uint32_t>(unzigzag(step));
    last_length_ = static_cast<std::size_t>(std::bit_width(step));
    for (std::size_t i = 0; i < kGuesses; ++i) {
      const auto length = static_cast<std::uint32_t>(std::bit_width(distance(place, guesses[i])));
      cost_[i] = cost_[i] - (cost_[i] >> kMemory) + length;
    }
    next_ = place + 1;
  }

  /// The place after the last one; 0 at first.
  std::uint32_t next() const noexcept { return next_; }

 private:
  static constexpr unsigned kMemory = 5;

  static std::uint32_t distance(std::uint32_t place, std::uint32_t guess) noexcept {
    return zigzag(static_cast<std::int32_t>(place - guess));
  }

  Coder& coder_;
  std::array<std::uint32_t, kGuesses> cost_{};  ///< smoothed bit lengths
  std::size_t last_length_ = 0;
  std::vector<NumberModel> steps_ = std::vector<NumberModel>(33);  ///< by the bit length of the step before
  std::uint32_t next_ = 0;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class OrderCoder {
 public:
  /// `triangles`: m x 3, as coded.
  OrderCoder(Coder& coder, std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : coder_(coder),
        triangles_(triangles),
        chains_(triangles, vertex_count),
        vertex_seen_(vertex_count, 0),
        vertex_taken_(vertex_count, 0),
        face_taken_(triangles.size() / 3, 0),
        vertex_places_(coder),
        face_places_(coder) {}

  /// Codes `order`, which a writer reads and a reader fills in, at its full size. Returns nothing, or the
  /// rule that a reader's order breaks; the reader's own failure comes first. O(n + m).
  const char* code(MeshOrder& order) {
    for (std::uint32_t f = 0; f < order.faces.size(); ++f) {
      const auto gate = chains_.find(triangles_[3 * f + 1], triangles_[3 * f]);
      if (!code_vertices(order.vertices, f, gate)) return "ORDR-2";
      if (!code_rotation(order, f)) return "ORDR-3";
      if (!code_face(order, f, gate)) return "ORDR-2";
      chains_.add(f);
    }
    for (std::uint32_t v = 0; v < order.vertices.size(); ++v) {
      if (vertex_seen_[v] == 0 && !code_vertex(order.vertices[v], all_of_them(vertex_places_.next())))
        return "ORDR-2";
    }
    return nullptr;
  }

 private:
  static constexpr std::size_t kGuesses = 3;
  using Places = PlaceCoder<Coder, kGuesses>;
  using Guesses = typename Places::Guesses;
  using Corner = std::optional<std::uint32_t>;  ///< of the face across a face's first edge

  static Guesses all_of_them(std::uint32_t guess) noexcept { return {guess, guess, guess}; }

  static bool take(std::vector<std::uint8_t>& taken, std::uint32_t place) noexcept {
    return place < taken.size() && std::exchange(taken[place], 1) == 0;
  }

  bool code_vertex(std::uint32_t& place, const Guesses& guesses) {
    vertex_places_.code(place, guesses);
    return take(vertex_taken_, place);
  }

  bool code_vertices(std::vector<std::uint32_t>& places, std::uint32_t face, Corner gate) {
    for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
      const std::uint32_t vertex = triangles_[corner];
      if (std::exchange(vertex_seen_[vertex], 1) != 0) continue;
      Guesses guesses = all_of_them(vertex_places_.next());
      if (corner % 3 == 2 && gate) {
        const std::uint32_t first = places[triangles_[3 * face]];
        guesses[1] = first + 1;
        guesses[2] = first + places[triangles_[3 * face + 1]] - places[triangles_[previous_in_face(*gate)]];
      }
      if (!code_vertex(places[vertex], guesses)) return false;
    }
    return true;
  }

  /// The corners of a face with the largest and the smallest place; the first among equals.
  struct Extremes {
    std::uint32_t largest_corner = 0;
    std::uint32_t smallest_corner = 0;
    std::uint32_t largest = 0;
  };
  Extremes extremes(const std::vector<std::uint32_t>& places, std::uint32_t face) const noexcept {
    std::array<std::uint32_t, 3> own;
    for (std::uint32_t k = 0; k < 3; ++k) own[k] = places[triangles_[3 * face + k]];
    const auto largest = std::max_element(own.begin(), own.end());
    const auto smallest = std::min_element(own.begin(), own.end());
    return {static_cast<std::uint32_t>(largest - own.begin()),
            static_cast<std::uint32_t>(smallest - own.begin()), *largest};
  }

  bool code_rotation(MeshOrder& order, std::uint32_t face) {
    const Extremes own = extremes(order.vertices, face);
    const unsigned symbol = coder_.symbol(
        order.rotation[face], Mixture<1>{{&rotations_[own.smallest_corner * 3 + own.largest_corner]}});
    order.rotation[face] = static_cast<std::uint8_t>(symbol);
    return symbol <= 2;
  }

  /// Files are often written by rows of vertices: faces then follow their latest vertices.
  bool code_face(MeshOrder& order, std::uint32_t face, Corner gate) {
    Guesses guesses = all_of_them(face_places_.next());
    if (face > 0) {
      const std::uint32_t near = gate ? *gate / 3 : face - 1;
      const std::int64_t rows = std::int64_t{extremes(order.vertices, face).largest} -
                                std::int64_t{extremes(order.vertices, near).largest};
      const std::int64_t faces_per_row = rows * static_cast<std::int64_t>(order.faces.size()) /
                                         static_cast<std::int64_t>(order.vertices.size());
      guesses[1] = order.faces[near] + 1;
      guesses[2] = guesses[1] + static_cast<std::uint32_t>(faces_per_row);
    }
    face_places_.code(order.faces[face], guesses);
    return take(face_taken_, order.faces[face]);
  }

  static constexpr SymbolModel kFreshRotation{{8, 8, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  Coder& coder_;
  std::span<const std::uint32_t> triangles_;
  CornerChains chains_;
  std::vector<std::uint8_t> vertex_seen_;   ///< per coded vertex
  std::vector<std::uint8_t> vertex_taken_;  ///< per place
  std::vector<std::uint8_t> face_taken_;    ///< per place
  Places vertex_places_;
  Places face_places_;
  std::vector<SymbolModel> rotations_ = std::vector(9, kFreshRotation);
};

}  // namespace deltamesh
