// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coded part of a patch, and what base and patch make together [MAP-17].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/result.h"
#include "patch/coder.h"

namespace deltamesh {

struct PatchPlan {
  std::vector<std::uint8_t> stays;   ///< for every face of the base: 1 if it stays
  std::vector<std::uint32_t> joins;  ///< for every vertex of the inserted mesh: the base's, or kNotJoined
};

/// Joined vertices are on open edges of the inserted mesh and of the faces that stay, no two on the same.
/// `base` and `inserted` as they are decoded.
std::vector<std::byte> write_patch_plan(const Mesh& base, const Mesh& inserted, PatchPlan plan);

/// `inserted` may be without faces. Errors: kInvalidStream [MAP-17], kTruncated.
Result<PatchPlan> read_patch_plan(std::span<const std::byte> bytes, const Mesh& base, const Mesh& inserted);

/// The part `key`: the faces that stay with their vertices, and behind them what is inserted but for joined
/// vertices. `base`, `inserted`: with the same attributes; `inserted` may be without faces and attributes.
MapPart put_together(const PartKey& key, const MapPart& base, const MapPart& inserted, const PatchPlan& plan);

/// Corners of the faces that stay.
std::vector<std::uint32_t> staying_triangles(const Mesh& base, const std::vector<std::uint8_t>& stays);

/// The base's vertices that put_together() begins with, ascending.
std::vector<std::uint32_t> staying_vertices(const Mesh& base, const PatchPlan& plan);

}  // namespace deltamesh
