// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What Draco's quantisers leave of a primitive: its error without a search for corresponding vertices.
#pragma once

#include <cstddef>
#include <span>

#include "asset/draco_primitive.h"

namespace deltamesh::bench {

/// The mesh that a primitive decodes to, vertex by vertex: from Draco's quantisers alone, which no coder
/// behind them changes.
Mesh draco_values(const Primitive& primitive, const DracoSetting& setting);

/// Whether the points of `stream`, decoded, are the vertices of `values`, each combination of values counted
/// once.
bool decodes_to(std::span<const std::byte> stream, const Mesh& values);

}  // namespace deltamesh::bench
