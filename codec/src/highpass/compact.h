// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact forms of DELT, quantised deltas as a field on the graph [DELT-5], and of ANCH [ANCH-3, ANCH-4,
// ANCH-5].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "deltamesh/result.h"
#include "entropy/coder/number_model.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// `deltas`: x of all n vertices of `graph`, then y, then z, at most 2^30 in size. O(n + edges).
std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph);

/// The same numbers back. Errors: kTruncated, kInvalidStream [CMP-3, FLD-1].
Result<LargeVector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph);

/// The numbers of an ANCH payload.
struct AnchorList {
  std::vector<std::uint32_t> gaps;   ///< vertices between an anchor and the one before
  std::vector<std::uint32_t> steps;  ///< zigzag of cell differences: x of all anchors, then y, then z
};

/// `Coder` is CompactWriter, or CompactReader, which fills `list` in.
template <class Coder>
void code_anchors(Coder& coder, AnchorList& list) {
  NumberModel gaps;
  std::array<NumberModel, 3> steps;
  const std::size_t count = list.gaps.size();
  for (std::size_t i = 0; i < count; ++i) {
    list.gaps[i] = coder.number(list.gaps[i], gaps);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint32_t& step = list.steps[axis * count + i];
      step = coder.number(step, steps[axis]);
    }
  }
}

std::vector<std::byte> write_compact_anchors(AnchorList list);

/// `count` is at most the number of vertices. Errors: kTruncated, kInvalidStream [CMP-3].
Result<AnchorList> read_anchors(std::span<const std::byte> payload, std::uint32_t count);

}  // namespace deltamesh
