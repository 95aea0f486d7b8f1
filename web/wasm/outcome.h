// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a call hands to JavaScript, which reads the same layout (packages/decoder/outcome.js). Pointers have
// 32 bits; strings end with a zero where no length stands beside them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "deltamesh/result.h"

namespace deltamesh::web {

static_assert(static_cast<int>(WhereKind::kPrimitive) == 8, "outcome.js has a word for each kind");

/// At the begin of every outcome.
struct ErrorOutcome {
  std::uint32_t code = 0;  ///< an ErrorCode; 0: no error
  const char* message = nullptr;
  const char* rule = nullptr;
  std::uint32_t where_kind = 0;
  double where = 0;
  std::uint32_t chunk_tag = 0;
};

inline ErrorOutcome outcome_of(const Error& error) noexcept {
  return {.code = static_cast<std::uint32_t>(error.code),
          .message = error.message,
          .rule = error.rule,
          .where_kind = static_cast<std::uint32_t>(error.where_kind),
          .where = static_cast<double>(error.where),
          .chunk_tag = error.chunk_tag};
}

struct AttributeOutcome {
  double error = 0;
  const char* name = nullptr;
  std::uint32_t name_bytes = 0;
  std::uint32_t kind = 0;
  std::uint32_t type = 0;
  std::uint32_t components = 0;
  std::uint32_t flags = 0;  ///< [ATTR-1]: 1 normalized, 2 linear light
  std::uint32_t coded_bytes = 0;
  const void* values = nullptr;  ///< where decoded
};

struct ChunkOutcome {
  std::uint32_t tag = 0;
  std::uint32_t codec = 0;  ///< 0 raw, 1 zstd, 2 compact
  std::uint32_t coded_bytes = 0;
  std::uint32_t decoded_bytes = 0;
};

/// The modules that `core` may need.
enum class Part : std::uint32_t { kHighpass, kZstd, kRare, kGrid };

struct StreamOutcome {
  ErrorOutcome error;
  std::uint32_t geometry = 0;  ///< 1 highpass, 2 predictive, 3 grid
  std::uint32_t parts = 0;     ///< that it needs beside core, bits by Part
  double origin[3]{};
  double box[6]{};
  double quality[3]{};  ///< VDE, LFE, largest error
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t keeps_order = 0;
  std::uint32_t attribute_count = 0;
  const AttributeOutcome* attributes = nullptr;
  std::uint32_t chunk_count = 0;
  const ChunkOutcome* chunks = nullptr;
  const float* positions = nullptr;  ///< where decoded, as all below
  const std::uint32_t* indices = nullptr;
  const std::uint32_t* groups = nullptr;  ///< null where there is one group
};

static_assert(sizeof(ErrorOutcome) == 32 && sizeof(AttributeOutcome) == 40 && sizeof(ChunkOutcome) == 16);
static_assert(offsetof(StreamOutcome, parts) == 36 && offsetof(StreamOutcome, vertices) == 136 &&
              offsetof(StreamOutcome, groups) == 172);

}  // namespace deltamesh::web
