// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a geometry coder gives the encoder, and the stream around it.
#pragma once

#include <cstdint>

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
};

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
    return write_container(whole, all.chunks()).size();
  }
};

}  // namespace deltamesh
