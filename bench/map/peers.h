// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What else could be sent of a block.
#pragma once

#include <cstddef>

#include "deltamesh/mesh.h"
#include "map/exchange.h"

namespace deltamesh::bench {

/// As nvblox sends it: positions of 12 bytes, colours of 16, triangles of 12, the block's index and lengths.
std::size_t raw_bytes(const Mesh& block);

struct CodedBlock {
  std::size_t bytes = 0;
  double encode_seconds = 0;
  double decode_seconds = 0;
};

/// Draco at level 10 with the fewest position bits that keep the largest error, and 8-bit colours in steps of
/// 2 * color_error + 1. Exits where Draco fails.
CodedBlock draco_block(const Mesh& block, const Bounds& bounds);

/// A stream of our own.
CodedBlock plain_block(const Mesh& block, const Bounds& bounds);

}  // namespace deltamesh::bench
