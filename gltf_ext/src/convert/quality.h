// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the options of a whole asset mean for one of its streams.
#pragma once

#include "deltamesh/encode.h"
#include "stream/mesh.h"

namespace deltamesh::gltf {

/// What merge_primitives() may leave out: nothing that the caller or the plan keeps.
MergeOptions merge_options(const EncodeOptions& asked, const StreamPlan& plan) noexcept;

/// Percentages, also those that the encoder takes where nothing is asked for, count in the diagonal of the
/// smallest mesh of the stream. Displacements of morph targets get bounds where the caller names none: of
/// positions the bound on those, or their error where another quality is asked for (which takes one more
/// encoding); of normals and tangents the angle's. Errors: as encode().
Result<EncodeOptions> stream_options(const EncodeOptions& asked, const StreamMesh& stream);

/// The step of a lattice on which positions are within what `options`, which are from stream_options(), ask:
/// 0 where only exact ones are. Equal positions are at equal points of lattices of one step, whatever the
/// stream. May take one encoding. Errors: as encode().
Result<double> lattice_step(const EncodeOptions& options, const Mesh& mesh);

/// `options` with positions on the lattice of this step, above 0, instead of a quality.
EncodeOptions lattice_options(const EncodeOptions& options, double step);

/// Positions and attributes to the last bit, and nothing else that contradicts this.
EncodeOptions lossless_options(const EncodeOptions& asked);

}  // namespace deltamesh::gltf
