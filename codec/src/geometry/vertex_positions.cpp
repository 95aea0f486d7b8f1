// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/vertex_positions.h"

#include <cmath>

namespace deltamesh {

Result<std::vector<Vec3>> to_float_positions(std::span<const Vec3> positions) {
  std::vector<Vec3> rounded(positions.begin(), positions.end());
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    for (double& x : rounded[i]) {
      x = static_cast<float>(x);
      if (!std::isfinite(x))
        return Error{.code = ErrorCode::kInvalidStream,
                     .message = "a decoded coordinate is not a finite float32",
                     .rule = "GEO-1",
                     .where_kind = WhereKind::kVertex,
                     .where = i};
    }
  }
  return rounded;
}

}  // namespace deltamesh
