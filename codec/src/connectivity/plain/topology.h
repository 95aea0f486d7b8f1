// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// CONN, SEAM and FGRP in the plain form: indices of faces, geometric vertices of vertices, groups of faces,
// in any order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh {

/// The corners 0 of all faces in an order whose indices take few bytes: depth first across edges, each face
/// beginning with the edge that it was reached by. `triangles`: m x 3 indices below `vertex_count`, any soup.
/// O(n + m).
std::vector<std::uint32_t> walk_faces(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

/// `triangles`: m x 3 vertices of the mesh.
std::vector<std::byte> write_plain_faces(std::span<const std::uint32_t> triangles);
/// Below `vertex_count`. Errors: kTruncated, kInvalidStream [PLN-2].
Result<std::vector<std::uint32_t>> read_plain_faces(std::span<const std::byte> payload,
                                                    std::uint32_t triangle_count, std::uint32_t vertex_count);

/// `geometric`: of every vertex, numbered by first appearance; empty where each vertex is its own.
std::vector<std::byte> write_plain_seams(std::span<const std::uint32_t> geometric);
/// The same. Errors: kTruncated, kInvalidStream [PLN-3].
Result<std::vector<std::uint32_t>> read_plain_seams(std::span<const std::byte> payload,
                                                    std::uint32_t geometric_count,
                                                    std::uint32_t vertex_count);

/// `groups`: m numbers, or none.
std::vector<std::byte> write_plain_groups(std::span<const std::uint32_t> groups);
/// The same; none from an empty payload. Errors: kTruncated, kInvalidStream [FGRP-1].
Result<std::vector<std::uint32_t>> read_plain_groups(std::span<const std::byte> payload,
                                                     std::uint32_t triangle_count);

}  // namespace deltamesh
