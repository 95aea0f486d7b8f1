// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors that name a block.
#pragma once

#include <cstdio>

#include "deltamesh/map/split.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Names the block: "block x y z", as far as there is room.
inline Error at_block(Error error, const MapBlock& block) {
  (void)std::snprintf(error.found.data(), error.found.size(), "block %d %d %d", block.cell[0], block.cell[1],
                      block.cell[2]);
  return error;
}

}  // namespace deltamesh
