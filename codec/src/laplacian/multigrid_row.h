// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four floats that are worked on at once: x, y, z and a pad that stays 0.
#pragma once

#include <vector>

namespace deltamesh::multigrid {

/// Element-wise arithmetic only, so that every instruction set gives the same bits.
using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

/// Both fields of a vertex side by side: one 32-byte load per neighbour serves both and all axes.
struct alignas(32) Row {
  Float4 x;  ///< position, or its equation's right-hand side
  Float4 s;  ///< residual field D^-1 (delta - L x), or its equation's right-hand side
};

}  // namespace deltamesh::multigrid
