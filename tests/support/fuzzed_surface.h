// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A small surface made of a fuzzer's bytes: any faces, copies and finite positions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "attributes/surface.h"

namespace deltamesh::test {

/// Bytes 0 and 1: how many vertices and faces, byte 2: bit 0 for copies, bit 1 for positions. Then 3 bytes a
/// face; a byte a vertex where there are copies; 12 bytes a vertex, floats, where there are positions.
class FuzzedSurface {
 public:
  explicit FuzzedSurface(std::span<const std::byte> bytes) : bytes_(bytes) {
    const unsigned vertices = 1 + byte() % 64;
    const unsigned faces = byte() % 128;
    const unsigned flags = byte();
    count_ = vertices;
    for (unsigned i = 0; i < 3 * faces; ++i) triangles_.push_back(byte() % vertices);
    for (unsigned i = 0; (flags & 1) != 0 && i < vertices; ++i) geometric_.push_back(byte() % (i + 1));
    for (unsigned i = 0; (flags & 2) != 0 && i < 3 * vertices; ++i) positions_.push_back(number());
  }

  /// Of arrays that this object holds.
  AttributeSurface surface() const { return {triangles_, count_, geometric_, positions_}; }
  std::uint32_t vertex_count() const noexcept { return count_; }
  std::span<const std::byte> rest() const noexcept { return bytes_; }

  unsigned byte() noexcept {
    if (bytes_.empty()) return 0;
    const auto value = std::to_integer<unsigned>(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return value;
  }
  /// Finite.
  float number() noexcept {
    std::array<std::uint8_t, 4> four{};
    for (std::uint8_t& x : four) x = static_cast<std::uint8_t>(byte());
    float value = 0;
    std::memcpy(&value, four.data(), sizeof value);
    return std::isfinite(value) ? value : 1;
  }

 private:
  std::span<const std::byte> bytes_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> geometric_;
  std::vector<float> positions_;
};

}  // namespace deltamesh::test
