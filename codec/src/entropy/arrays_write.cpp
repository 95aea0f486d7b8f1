// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <bit>

#include "entropy/arrays.h"

namespace deltamesh {
namespace {

template <class Number>
void write_numbers(ByteWriter& out, std::span<const Number> numbers) {
  if (numbers.empty()) return;
  Number all = 0;
  for (const Number number : numbers) all |= number;
  const unsigned planes = (static_cast<unsigned>(std::bit_width(all)) + 7) / 8;
  out.write(static_cast<std::uint8_t>(planes));
  for (unsigned plane = 0; plane < planes; ++plane) {
    for (const Number number : numbers) out.write(static_cast<std::uint8_t>(number >> (8 * plane)));
  }
}

}  // namespace

void write_array(ByteWriter& out, std::span<const std::uint32_t> numbers) { write_numbers(out, numbers); }

void write_differences(ByteWriter& out, std::span<const std::uint64_t> numbers, unsigned width) {
  const std::uint64_t mask = ~std::uint64_t{0} >> (64 - width);
  std::vector<std::uint64_t> codes;
  codes.reserve(numbers.size());
  std::uint64_t last = 0;
  for (const std::uint64_t number : numbers) {
    const std::uint64_t up = (number - last) & mask;
    codes.push_back((up >> (width - 1)) == 0 ? up << 1 : ((~up & mask) << 1) | 1);
    last = number;
  }
  write_numbers<std::uint64_t>(out, codes);
}

void write_indices(ByteWriter& out, std::span<const std::uint32_t> indices) {
  std::vector<std::uint32_t> codes;
  codes.reserve(indices.size());
  std::uint32_t fresh = 0;
  for (const std::uint32_t index : indices) {
    codes.push_back(fresh - index);
    fresh = std::max(fresh, index + 1);
  }
  write_array(out, codes);
}

}  // namespace deltamesh
