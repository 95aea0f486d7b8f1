// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole coloured meshes by default, beside exact colours and Draco: bytes and times.
#pragma once

#include <string>
#include <vector>

namespace deltamesh::bench {

/// Prints a table of `files` with their colours as the only attribute; those without 8-bit colours are left
/// out. One thread, all in turn. Returns 0, or exits where a file or the codec fails.
int compare_whole_meshes(const std::vector<std::string>& files);

}  // namespace deltamesh::bench
