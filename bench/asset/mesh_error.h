// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How far decoded meshes are from their originals: positions by their root mean square, every attribute by
// its largest error.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "asset/part.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

struct MeshError {
  double rms = 0;  ///< of positions, model units; each place of the original counts once
  /// Largest of each attribute, as compare() has it. Geometry: largest distance of a vertex.
  std::array<double, kParts> largest{};
};

/// Whether every figure of `a` is at most that of `b`, but for rounding.
bool is_within(const MeshError& a, const MeshError& b);

/// Collects the error of the meshes of a primitive set.
class MeshErrorMeter {
 public:
  /// `order`: the vertex of `original` for every vertex of `decoded`; both have the same attributes. Errors:
  /// compare()'s.
  Result<void> add(const Mesh& original, const Mesh& decoded, std::span<const std::uint32_t> order);
  MeshError error() const;

 private:
  std::unordered_set<std::string> places_;  ///< bits of the positions that have been counted
  double square_sum_ = 0;
  MeshError error_;
};

/// What a codec makes of one mesh of an asset.
struct CodedMesh {
  std::vector<std::vector<std::byte>> streams;
  PartBytes bytes{};  ///< kMorph: of streams and what is left plain
  MeshError error;    ///< of what the streams decode to
};

}  // namespace deltamesh::bench
