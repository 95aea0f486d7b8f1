// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What JavaScript hands to the encoder and gets back (packages/encoder/encode.js writes and reads the same
// layouts). Pointers have 32 bits; a number that is not given is NaN.
#pragma once

#include <cstddef>
#include <cstdint>

#include "outcome.h"

namespace deltamesh::web {

struct AttributeCall {
  const char* name;
  std::uint32_t name_bytes;
  std::uint32_t kind;
  std::uint32_t type;
  std::uint32_t components;
  std::uint32_t flags;  ///< 1 normalized, 2 linear light
  const std::byte* values;
  std::uint32_t value_bytes;
};

struct MeshCall {
  double origin[3];
  const float* positions;
  std::uint32_t vertices;
  const std::uint32_t* indices;
  std::uint32_t triangles;
  const std::uint32_t* groups;  ///< or null
  const AttributeCall* attributes;
  std::uint32_t attribute_count;
};

struct BoundCall {
  double value;
  double unit;
};

struct NamedCall {
  double error;
  double is_mean;
  const char* name;
  std::uint32_t name_bytes;
};

/// The members of EncodeOptions.
struct OptionsCall {
  BoundCall vde;
  BoundCall lfe;
  BoundCall max_error;
  double target_bytes;
  double geometry;
  double lossless;
  double effort;
  double bits;
  double step;
  double anchors;
  double anchor_density;
  double anchor_bits;
  double normal_error;
  double tangent_error;
  double uv_error;
  double color_error;
  double color_rms;
  double weight_error;
  double profile;
  double keep_order;
  double keep_unreferenced;
  const NamedCall* named;
  std::uint32_t named_count;
};

struct EncodeOutcome {
  ErrorOutcome error;
  double best_value = 0;  ///< where the request cannot be met
  double best_bytes = 0;
  const std::byte* bytes = nullptr;
  std::uint32_t byte_count = 0;
  const std::uint32_t* order = nullptr;  ///< input vertex of every decoded vertex
  std::uint32_t order_count = 0;
};

/// A GltfAttributeReport.
struct PackedAttributeOutcome {
  double bytes = 0;
  double error = 0;
  const char* semantic = nullptr;
  std::uint32_t semantic_bytes = 0;
  std::uint32_t kind = 0;
  std::uint32_t morph = 0;
};

struct PackOutcome {
  ErrorOutcome error;
  double counts[18]{};  ///< of GltfReport, as it has them, without files
  double max_error = 0;
  double max_error_percent = 0;
  const std::byte* bytes = nullptr;
  std::uint32_t byte_count = 0;
  const PackedAttributeOutcome* attributes = nullptr;
  std::uint32_t attribute_count = 0;
};

struct CompareOutcome {
  ErrorOutcome error;
  double quality[3]{};  ///< VDE, LFE, largest error, where vertices correspond
  double surface_rms = 0;
  double surface_max = 0;
  double normal_angle_mean = 0;
  double normal_angle_p95 = 0;
  double diagonal = 0;
  std::uint32_t corresponding = 0;
  const float* signed_error = nullptr;  ///< for every vertex of the second mesh
  std::uint32_t signed_error_count = 0;
};

static_assert(sizeof(AttributeCall) == 32 && sizeof(MeshCall) == 56 && sizeof(NamedCall) == 24);
static_assert(sizeof(PackedAttributeOutcome) == 32 && offsetof(PackOutcome, bytes) == 192);
static_assert(offsetof(OptionsCall, named) == 24 * 8 && offsetof(CompareOutcome, corresponding) == 96);

}  // namespace deltamesh::web
