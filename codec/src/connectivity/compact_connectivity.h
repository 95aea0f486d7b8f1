// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "connectivity/connectivity.h"
#include "connectivity/op_models.h"

namespace deltamesh {

/// The compact form of CONN [CONN-12 to CONN-14]. `triangle_count`: above 0. `learning`: of ops. Errors: as
/// read_connectivity().
Result<Connectivity> read_compact_connectivity(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                               std::uint32_t triangle_count,
                                               const Learning<OpModels>& learning);

}  // namespace deltamesh
