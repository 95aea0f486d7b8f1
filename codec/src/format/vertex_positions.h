// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The last step of every geometry coder: positions as the float32 numbers that users get.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Each coordinate rounded to the nearest float32 [GEO-1]. Errors: kInvalidStream where one does not fit.
Result<std::vector<Vec3>> to_float_positions(std::span<const Vec3> positions);

/// The same as n x 3 floats.
Result<std::vector<float>> to_float_rows(std::span<const Vec3> positions);

/// Errors: kInvalidStream where one of the coordinates, n x 3, is not finite [GEO-1].
Result<void> check_finite(std::span<const float> rows);

/// One row for each of `copies`, which are indices of `rows`, n x 3.
std::vector<float> copy_rows(std::span<const float> rows, std::span<const std::uint32_t> copies);

}  // namespace deltamesh
