// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Orders of the vertices in which more parallelograms end at each than in the order of the faces [POSN-10].
#pragma once

#include <cstdint>
#include <vector>

#include "positions/surroundings.h"

namespace deltamesh {

/// Values as in the stream, two bits.
enum class CodingOrder : std::uint8_t {
  kAsDecoded = 0,
  kBroad = 1,  ///< among equally surrounded vertices, the first in goes first
  kDeep = 2,   ///< the last in goes first
};

/// `Coder` is CompactWriter or CompactReader. False where there is no such coding order.
template <class Coder>
bool code_coding_order(Coder& coder, CodingOrder& coding_order) {
  const std::uint32_t coded = coder.bits(static_cast<std::uint32_t>(coding_order), 2);
  coding_order = static_cast<CodingOrder>(coded);
  return coded <= static_cast<std::uint32_t>(CodingOrder::kDeep);
}

/// The known faces of the vertex at every place of the order. Sets `order` to the vertex at every place;
/// empty for kAsDecoded. O(n + m).
KnownFaces known_in_order(const FaceList& list, CodingOrder coding_order, std::vector<std::uint32_t>& order);

}  // namespace deltamesh
