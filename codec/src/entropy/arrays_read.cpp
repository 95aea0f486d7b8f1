// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/checked.h"
#include "base/try.h"
#include "entropy/arrays.h"

namespace deltamesh {
namespace {

template <class Number>
Result<std::vector<Number>> read_numbers(ByteReader& in, std::uint64_t count, unsigned width) {
  if (count == 0) return std::vector<Number>();
  DELTAMESH_TRY(const auto planes, in.read<std::uint8_t>());
  if (8U * planes > width) return in.invalid("more byte planes than numbers have bytes", "CON-5");
  if (planes != 0 && count > in.remaining() / planes)
    return in.error(ErrorCode::kTruncated, "bytes end inside the byte planes", "CON-1");
  std::vector<Number> numbers(memory_size(count));
  for (unsigned plane = 0; plane < planes; ++plane) {
    DELTAMESH_TRY(const auto bytes, in.read_bytes(count));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      numbers[i] |= std::to_integer<Number>(bytes[i]) << (8 * plane);
  }
  return numbers;
}

}  // namespace

Result<std::vector<std::uint32_t>> read_array(ByteReader& in, std::uint64_t count) {
  return read_numbers<std::uint32_t>(in, count, 32);
}

Result<std::vector<std::uint64_t>> read_differences(ByteReader& in, std::uint64_t count, unsigned width) {
  DELTAMESH_TRY(auto numbers, read_numbers<std::uint64_t>(in, count, width));
  const std::uint64_t mask = ~std::uint64_t{0} >> (64 - width);
  std::uint64_t last = 0;
  for (std::uint64_t& number : numbers) {
    last += (number & 1) == 0 ? number >> 1 : ~(number >> 1);
    number = last & mask;
  }
  return numbers;
}

Result<std::vector<std::uint32_t>> read_indices(ByteReader& in, std::uint64_t count) {
  DELTAMESH_TRY(auto indices, read_array(in, count));
  std::uint32_t fresh = 0;
  for (std::uint32_t& index : indices) {
    index = fresh - index;
    fresh = std::max(fresh, index + 1);
  }
  return indices;
}

}  // namespace deltamesh
