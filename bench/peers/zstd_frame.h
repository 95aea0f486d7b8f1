// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Buffers in one zstd frame: how peers without an entropy coder are sent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "peers/lattice.h"

namespace deltamesh::bench {

inline constexpr int kZstdLevel = 19;

/// What begins a frame of lattice positions.
struct FrameHeader {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::array<float, 3> origin{};
  std::uint32_t vertex_bytes = 0;  ///< of what comes next, where it is coded
  double cell = 0;

  FrameHeader() = default;
  FrameHeader(const Mesh& mesh, const Lattice& lattice)
      : vertices(static_cast<std::uint32_t>(mesh.vertex_count())),
        triangles(static_cast<std::uint32_t>(mesh.triangle_count())),
        origin(lattice.origin),
        cell(lattice.cell) {}
  Lattice lattice() const { return {.origin = origin, .cell = cell}; }
};

template <class T>
void append(std::vector<std::byte>& out, std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Fills `values` from the front of `bytes` and drops what it took; false where too few are left.
template <class T>
bool take(std::span<const std::byte>& bytes, std::span<T> values) {
  if (bytes.size() < values.size_bytes()) return false;
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size_bytes());
  bytes = bytes.subspan(values.size_bytes());
  return true;
}

/// Errors: kInternal, so for the next.
Result<std::vector<std::byte>> zstd_frame(std::span<const std::byte> raw);
Result<std::vector<std::byte>> open_zstd_frame(std::span<const std::byte> frame);

}  // namespace deltamesh::bench
