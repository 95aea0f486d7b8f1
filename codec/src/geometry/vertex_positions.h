// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The last step of every geometry coder: positions as the float32 numbers that users get.
#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Each coordinate rounded to the nearest float32 [GEO-1]. Errors: kInvalidStream where one does not fit.
Result<std::vector<Vec3>> to_float_positions(std::span<const Vec3> positions);

}  // namespace deltamesh
