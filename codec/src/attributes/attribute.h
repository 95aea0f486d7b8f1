// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ATTR: one per-vertex attribute, quantised by kind: normals on the octahedron, colours to fewer levels,
// texture coordinates over their range; everything else exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "entropy/payload.h"
#include "topology/adjacency.h"

namespace deltamesh {

struct AttributeQuantization {
  int normal_bits = 10;
  int color_bits = 8;
  int uv_bits = 12;
  bool exact = false;  ///< every attribute to the last bit
};

/// `order`: the row of `attribute` for every coded vertex. An attribute of a known kind whose shape does not
/// fit the kind (a colour of doubles, say), or that is not finite, is stored exactly. Errors: kInvalidMesh
/// (sizes that disagree).
Result<std::vector<std::byte>> write_attribute(const AttributeView& attribute,
                                               std::span<const std::uint32_t> order,
                                               const AttributeQuantization& quantization);

/// The same payload in the compact form, empty where the attribute has none. `graph`: over the coded
/// vertices.
Result<std::vector<std::byte>> write_compact_attribute(const AttributeView& attribute,
                                                       std::span<const std::uint32_t> order,
                                                       const AttributeQuantization& quantization,
                                                       const Adjacency& graph);

/// `graph`: over the coded vertices; asked for only where the payload is compact. Errors: kTruncated,
/// kInvalidStream [ATTR-*], kLimitExceeded where the values would take more than `max_bytes`.
Result<Attribute> read_attribute(Payload payload, std::uint32_t vertex_count, std::uint64_t max_bytes,
                                 const Adjacency* graph = nullptr);

}  // namespace deltamesh
