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
#include "entropy/number_model.h"
#include "entropy/payload.h"

namespace deltamesh {

struct AnchorList {
  std::vector<std::uint32_t> gaps;   ///< vertices between an anchor and the one before
  std::vector<std::uint32_t> steps;  ///< zigzag of cell differences: x of all anchors, then y, then z
};

/// Of the compact form.
struct AnchorModels {
  NumberModel gaps;
  std::array<NumberModel, 3> steps;
};

std::vector<std::byte> write_plain_anchors(const AnchorList& list);
std::vector<std::byte> write_compact_anchors(const AnchorList& list);

/// `count` is at most the number of vertices. Errors: kTruncated, kInvalidStream [CON-1, CON-5, CMP-3].
Result<AnchorList> read_anchors(Payload payload, std::uint32_t count);

}  // namespace deltamesh
