// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What 8-bit colours take at equal mean error: within bounds, by the transform over the mesh, by an octree's,
// and by Draco with fewer bits.
#pragma once

#include <string>
#include <vector>

namespace deltamesh::bench {

/// Prints a table of `files`, predictive geometry at effort 0; those without 8-bit colours are left out, as
/// is their alpha. `out`: a folder for plots, or empty. Returns 0, 4 where a plot cannot be written, or exits
/// where a file or the codec fails.
int compare_color_rates(const std::vector<std::string>& files, const std::string& out);

}  // namespace deltamesh::bench
