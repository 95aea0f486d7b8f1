// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All attributes of a mesh, coded on the surface that decoders will have.
#pragma once

#include "deltamesh/attribute_quality.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "encoder/coded_topology.h"
#include "entropy/chunk_list.h"
#include "search/candidate.h"

namespace deltamesh {

/// Whether any attribute may cost less where decoders know the positions to the bit [ATTR-10].
bool attributes_use_positions(const MeshView& mesh, const EncodeOptions& options) noexcept;

/// One chunk for each attribute, in the mesh's order, within options.attributes, on `geometry`, whose order
/// `topology` has. `about`: see AttributeSettings. Errors: kInvalidMesh.
Result<ChunkList> code_attributes(const MeshView& mesh, const CodedTopology& topology,
                                  const EncodeOptions& options, const Candidate& geometry,
                                  bool about = false);

/// `quality` with every bound `scale` times as large, at most to where an attribute would mean nothing any
/// more, or no larger than asked (is_asked). What is exact stays so. `scale`: above 0.
AttributeQuality scaled(const AttributeQuality& quality, double scale);

}  // namespace deltamesh
