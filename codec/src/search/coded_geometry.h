// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Result of a geometry coder, and the rest of the stream.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/stream_info.h"
#include "encoder/chunk_list.h"
#include "format/header.h"

namespace deltamesh {

/// A coded geometry and what a decoder makes of it.
struct CodedGeometry {
  std::uint8_t coder = kGeometryHighpass;
  HighpassParameters highpass{};
  PredictiveParameters predictive{};
  ChunkList chunks;
  Quality quality{};
  /// n x 3 floats as decoded, of geometric vertices; empty of a highpass geometry.
  std::vector<float> positions{};

  void set_parameters(FileHeader& header) const {
    header.geometry = coder;
    header.highpass = highpass;
    header.predictive = predictive;
  }
};

/// The rest of the stream, so that its size is known.
struct StreamRest {
  const FileHeader& header;
  std::uint64_t chunk_bytes;  ///< of the chunks that are not the geometry's

  std::uint64_t bytes_with(const CodedGeometry& geometry) const {
    FileHeader whole = header;
    geometry.set_parameters(whole);
    return stream_bytes(whole, chunk_bytes + geometry.chunks.bytes());
  }
};

}  // namespace deltamesh
