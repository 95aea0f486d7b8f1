// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What writing an attribute's values gives.
#pragma once

#include <cstddef>
#include <vector>

namespace deltamesh {

/// In the coding of its kind.
template <class T>
struct CodedValues {
  std::vector<std::byte> bytes;  ///< what follows the byte of the coding [ATTR-2]
  std::vector<T> values;         ///< of all vertices, as decoders get them
};

}  // namespace deltamesh
