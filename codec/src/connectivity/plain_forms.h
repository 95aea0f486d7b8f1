// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Readers of the plain forms of CONN, SEAM, FGRP and ORDR, which are written for zstd. Each form has a source
// of its own: small decoders leave them to another module (web/wasm).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "connectivity/faces/gluing.h"
#include "connectivity/order/order.h"
#include "connectivity/seams/corner_copies.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// CONN [CONN-2, CONN-9 to CONN-11]. `triangle_count`: above 0. Both counts are checked against the bytes
/// present before anything of their size is allocated. Errors: kTruncated, kInvalidStream [CONN-*].
Result<ManifoldFaces> read_plain_faces(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                       std::uint32_t triangle_count);

/// SEAM. `extra_copies`: vertices beyond the geometric ones, above 0. Errors: kTruncated, kInvalidStream
/// [SEAM-1 to SEAM-4].
Result<CornerCopies> read_plain_copies(std::span<const std::byte> bytes,
                                       std::span<const std::uint32_t> geometric_triangles,
                                       std::uint32_t geometric_count, std::uint32_t extra_copies);

/// FGRP: m numbers. Errors: kTruncated, kInvalidStream [FGRP-1].
Result<std::vector<std::uint32_t>> read_plain_groups(std::span<const std::byte> bytes,
                                                     std::uint32_t triangle_count);

/// ORDR. Errors: kTruncated, kInvalidStream [ORDR-1 to ORDR-3].
Result<MeshOrder> read_plain_order(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                   std::uint32_t triangle_count);

}  // namespace deltamesh
