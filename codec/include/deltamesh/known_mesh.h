// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh that encoder and decoder share, to code a similar one beside it.
#pragma once

#include <cstdint>
#include <span>

#include "deltamesh/mesh.h"

namespace deltamesh {

/// A mesh that encoder and decoder have, such as the version of a map's part before the present one. Streams
/// of grids take fewer bytes beside it.
struct KnownMesh {
  std::span<const float> positions;          ///< n x 3, finite
  std::span<const std::uint32_t> triangles;  ///< m x 3, below n
  /// Those of the stream, in its order, with n values each; or none. Colours take fewer bytes beside them.
  std::span<const Attribute> attributes{};
};

}  // namespace deltamesh
