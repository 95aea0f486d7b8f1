// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours at equal PSNR of luma: within bounds on every component, and by the transform at a mean error.
#pragma once

#include <string>
#include <vector>

namespace deltamesh::bench {

/// Prints a table of `files`, predictive geometry at effort 0; those without 8-bit colours are left out, as
/// is their alpha. Returns 0, or exits where a file or the codec fails.
int compare_color_rates(const std::vector<std::string>& files);

}  // namespace deltamesh::bench
