// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of maps at 8 bits a component beside Draco's at level 10, exact, and within bounds.
#pragma once

#include <string>
#include <vector>

namespace deltamesh::bench {

/// Prints a table of `files`; those without 8-bit colours are left out. Returns 0, or exits where a file or a
/// codec fails.
int compare_colors(const std::vector<std::string>& files);

}  // namespace deltamesh::bench
