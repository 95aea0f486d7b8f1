// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions of a mesh coded as a request asks, by the coder that it asks for or that suits it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "encoder/source_geometry.h"
#include "search/coded_geometry.h"

namespace deltamesh {

/// Bytes that attributes would take on decoded positions, n x 3 floats of geometric vertices; on none where
/// decoders may differ in their last bits.
using AttributeBytes = std::function<Result<std::uint64_t>(std::span<const float> positions)>;

struct GeometryTask {
  const EncodeOptions& options;
  const SourceGeometry& source;
  StreamRest rest;
  AttributeBytes attribute_bytes{};  ///< may be empty: the same for all geometries
};

/// Errors: kUnmetRequest; kInvalidMesh for coordinates that no stream can hold.
Result<CodedGeometry> code_geometry(const GeometryTask& task);

}  // namespace deltamesh
