// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All attributes of a mesh, coded on the surface that decoders will have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "encoder/chunk_list.h"
#include "encoder/coded_topology.h"
#include "format/attribute_descriptor.h"

namespace deltamesh {

struct CodedAttributes {
  ChunkList chunks;  ///< one for each attribute, in the mesh's order
  std::vector<AttributeDescriptor> descriptors{};

  std::uint64_t bytes() const noexcept;
};

/// The arguments must outlive it.
class AttributeStage {
 public:
  AttributeStage(const MeshView& mesh, const CodedTopology& topology, const EncodeOptions& options)
      : mesh_(mesh), topology_(topology), options_(options) {}

  /// Whether any attribute may cost less where decoders know the positions to the bit [ATTR-10].
  bool uses_positions() const noexcept;

  /// `positions`: n x 3 floats as decoded, of geometric vertices, or empty where decoders may differ in their
  /// last bits. Errors: kInvalidMesh.
  Result<CodedAttributes> code(const AttributeQuality& quality, std::span<const float> positions) const;

 private:
  const MeshView& mesh_;
  const CodedTopology& topology_;
  const EncodeOptions& options_;
};

}  // namespace deltamesh
