// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The numbers of an ANCH payload, in the plain and in the compact form [ANCH-3, ANCH-4, ANCH-5].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/coder/number_model.h"
#include "entropy/payload.h"

namespace deltamesh {

struct AnchorList {
  std::vector<std::uint32_t> gaps;   ///< vertices between an anchor and the one before
  std::vector<std::uint32_t> steps;  ///< zigzag of cell differences: x of all anchors, then y, then z
};

/// The compact form: `Coder` is CompactWriter, or CompactReader, which fills `list` in.
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

std::vector<std::byte> write_plain_anchors(const AnchorList& list);
std::vector<std::byte> write_compact_anchors(AnchorList list);

/// `count` is at most the number of vertices. Errors: kTruncated, kInvalidStream [CON-1, CON-5, CMP-3].
Result<AnchorList> read_anchors(Payload payload, std::uint32_t count);

}  // namespace deltamesh
