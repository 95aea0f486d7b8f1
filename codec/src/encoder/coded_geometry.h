// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a geometry coder gives the encoder, and the stream around it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "deltamesh/stream_info.h"
#include "encoder/chunk_list.h"
#include "format/container.h"
#include "format/header.h"

namespace deltamesh {

/// A coded geometry and what a decoder makes of it.
struct GeometryChoice {
  std::uint8_t geometry = kGeometryHighpass;
  HighpassParameters highpass{};
  PredictiveParameters predictive{};
  ChunkList chunks;
  Quality quality{};
  /// n x 3 floats as decoded, of geometric vertices; empty of a highpass geometry.
  std::vector<float> positions{};
};

/// Bytes that attributes would take on decoded positions, n x 3 floats of geometric vertices; on none where
/// decoders may differ in their last bits.
using AttributeBytes = std::function<Result<std::uint64_t>(std::span<const float> positions)>;

/// The rest of the stream, so that its size is known; the geometry is coded like `before`.
struct StreamFrame {
  const FileHeader& header;
  const ChunkList& before;
  const ChunkList& after;

  std::uint64_t bytes_with(const GeometryChoice& geometry) const {
    FileHeader whole = header;
    whole.geometry = geometry.geometry;
    whole.highpass = geometry.highpass;
    whole.predictive = geometry.predictive;
    ChunkList all = before;
    all.append(geometry.chunks);
    all.append(after);
    return container_bytes(whole, all.chunks());
  }
};

}  // namespace deltamesh
