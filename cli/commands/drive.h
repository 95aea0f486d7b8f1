// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A generated drive as a folder of updates.
#pragma once

#include <cstdint>
#include <string>

namespace deltamesh::cli {

/// Writes `steps` updates of a drive through rooms of `vertices` vertices; returns the exit code.
int write_drive(const std::string& folder, std::uint32_t steps, std::uint64_t vertices, std::uint64_t seed);

}  // namespace deltamesh::cli
