// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All attributes of a mesh, coded on the surface that decoders will have.
#pragma once

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

}  // namespace deltamesh
