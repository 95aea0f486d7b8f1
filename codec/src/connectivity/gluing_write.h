// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Writes which manifold vertices are one vertex of the mesh [CONN-11, CONN-13].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "connectivity/gluing.h"
#include "entropy/compact_writer.h"

namespace deltamesh {

/// `vertex`: as from glue_vertices().
GlueList list_glued(std::span<const std::uint32_t> vertex);

/// The gluing by the compact coder: the list's length, then the list itself, or where it is long the vertices
/// one by one [CONN-13, CONN-14]. `faces`: manifold vertices, three each; `vertex`: as from
/// glue_vertices().
void write_compact_gluing(CompactWriter& writer, std::span<const std::uint32_t> faces,
                          std::vector<std::uint32_t> vertex);

}  // namespace deltamesh
