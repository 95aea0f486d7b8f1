// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// For `grid`, whose rest has no positions but those on a lattice [GRD-11].
#include "positions/positions.h"

namespace deltamesh {

Result<std::vector<float>> read_float_positions(std::span<const std::byte>, const FaceList&, const Box&) {
  return Error{.code = ErrorCode::kInternal};
}

}  // namespace deltamesh
