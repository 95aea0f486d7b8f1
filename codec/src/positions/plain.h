// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// POSN in the plain form: lattice coordinates or floats, axis by axis [PLN-5].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "format/predictive_parameters.h"
#include "positions/blend/blend.h"

namespace deltamesh {

std::vector<std::byte> write_plain_cells(std::span<const Cell> cells);

/// Of positions that are floats, PositionKind::kFloats.
std::vector<std::byte> write_plain_floats(std::span<const Vec3> positions);

/// n x 3. Errors: kTruncated, kInvalidStream [PLN-5, GEO-1].
Result<std::vector<float>> read_plain_positions(std::span<const std::byte> payload,
                                                std::uint32_t vertex_count,
                                                const PredictiveParameters& parameters);

}  // namespace deltamesh
