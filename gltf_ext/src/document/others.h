// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bytes of an asset that no mesh has.
#pragma once

#include <cstdint>

#include "io/gltf/document.h"

namespace deltamesh::gltf {

struct OtherBytes {
  std::uint64_t animations = 0;  ///< samplers' accessors
  std::uint64_t images = 0;      ///< within the asset; files of their own do not count
};

/// Data that several have in common counts once, and what is malformed not at all. Precondition:
/// check_other_accessors().
OtherBytes count_others(const Document& document);

}  // namespace deltamesh::gltf
