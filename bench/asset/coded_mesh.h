// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a codec makes of one mesh of an asset.
#pragma once

#include <cstddef>
#include <vector>

#include "asset/mesh_error.h"
#include "asset/part.h"

namespace deltamesh::bench {

struct CodedMesh {
  std::vector<std::vector<std::byte>> streams;
  PartBytes bytes{};  ///< kMorph: of streams and what is left plain
  MeshError error;
  bool is_verified = false;  ///< `error` was measured on what the streams decode to; else the encoder says so
};

}  // namespace deltamesh::bench
