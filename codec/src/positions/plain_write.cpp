// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <bit>

#include "base/byte_writer.h"
#include "entropy/arrays.h"
#include "positions/plain.h"

namespace deltamesh {
namespace {

/// Of `count` vertices; `number(v, axis)`: of 32 bits.
template <class Number>
std::vector<std::byte> write_axes(std::size_t count, const Number& number) {
  ByteWriter out;
  std::vector<std::uint64_t> numbers(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t v = 0; v < count; ++v) numbers[v] = number(v, axis);
    write_differences(out, numbers, 32);
  }
  return out.take();
}

}  // namespace

std::vector<std::byte> write_plain_cells(std::span<const Cell> cells) {
  return write_axes(cells.size(), [&](std::size_t v, std::size_t axis) {
    return static_cast<std::uint32_t>(cells[v][axis]);
  });
}

std::vector<std::byte> write_plain_floats(std::span<const Vec3> positions) {
  return write_axes(positions.size(), [&](std::size_t v, std::size_t axis) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(positions[v][axis]));
  });
}

}  // namespace deltamesh
