// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Source meshes and options of the golden streams. Together they exercise every rule of the format
// (scripts/check-conformance).
#pragma once

#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/mesh.h"

namespace deltamesh::test {

struct Golden {
  const char* name;  ///< tests/golden/<name>.v1d<draft>.dmsh and .off
  Mesh mesh;
  EncodeOptions options;
};

std::vector<Golden> golden_streams();

/// A rough surface with smooth colours: no repetition for zstd, neighbourhoods for the compact coder.
Mesh rough_grid();

}  // namespace deltamesh::test
