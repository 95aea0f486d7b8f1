// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The GLB container of glTF 2.0: a header, a JSON chunk, perhaps a BIN chunk, perhaps chunks unknown to us.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh::gltf {

struct GlbChunk {
  std::uint32_t type = 0;
  std::span<const std::byte> bytes;
};

/// Spans point into the file.
struct Glb {
  std::span<const std::byte> json;
  std::optional<std::span<const std::byte>> bin;
  std::vector<GlbChunk> others;  ///< in their order
};

bool is_glb(std::span<const std::byte> file) noexcept;

/// Bytes behind the length that the header states are left alone. Errors: kInvalidFile (`where`: byte).
Result<Glb> parse_glb(std::span<const std::byte> file);

/// Errors: kLimitExceeded above 4 GiB.
Result<std::vector<std::byte>> write_glb(std::string_view json, std::span<const std::byte> bin,
                                         std::span<const GlbChunk> others);

}  // namespace deltamesh::gltf
