// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which vertices of a sparse field are at rest as all around them are [ATTR-59]. One template for both
// directions.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "entropy/compact_model.h"
#include "predictive/surroundings.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class MovingVertices {
 public:
  MovingVertices(Coder& coder, const KnownFaces& faces)
      : coder_(coder), faces_(faces), moves_(faces.vertex_count(), 0) {
    models_.fill(BitModel(kFresh));
  }

  /// Whether the stream says that `vertex` is at rest, those before it being coded, so that no more is coded
  /// of it. A reader's `moves` is ignored. Else end() has to follow.
  bool rests(std::uint32_t vertex, bool moves) {
    const NearCorners near = faces_.near(vertex);
    return !moves_around(vertex, near) && !coder_.bit(moves, models_[near.known_count]);
  }
  void end(std::uint32_t vertex, bool moves) noexcept { moves_[vertex] = moves ? 1 : 0; }

 private:
  static constexpr std::uint16_t kFresh = 1024;  ///< parts of 2^16 that move

  bool moves_around(std::uint32_t vertex, const NearCorners& near) const noexcept {
    if (near.known_count == 0) return vertex > 0 && moves_[vertex - 1] != 0;
    const std::size_t last = near.known_count - 1;
    return (moves_[near.a[0]] | moves_[near.b[0]] | moves_[near.a[last]] | moves_[near.b[last]]) != 0;
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::vector<std::uint8_t> moves_;  ///< 1 or 0
  std::array<BitModel, 3> models_;
};

}  // namespace deltamesh
