// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace deltamesh::gltf {
namespace {

template <class T>
std::array<float, 3> read(const AccessorRows& rows, std::uint64_t i) noexcept {
  std::array<T, 3> values{};
  std::memcpy(values.data(), rows.row(i).data(), sizeof values);
  std::array<float, 3> position{};
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] = static_cast<float>(values[k]);
    if (std::is_integral_v<T> && rows.shape().normalized)
      position[k] = std::max(position[k] / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
  }
  return position;
}

}  // namespace

std::array<float, 3> position_of(const AccessorRows& rows, std::uint64_t i) noexcept {
  switch (rows.shape().type) {
    case ComponentType::kI8:
      return read<std::int8_t>(rows, i);
    case ComponentType::kU8:
      return read<std::uint8_t>(rows, i);
    case ComponentType::kI16:
      return read<std::int16_t>(rows, i);
    case ComponentType::kU16:
      return read<std::uint16_t>(rows, i);
    case ComponentType::kF32:
      return read<float>(rows, i);
    case ComponentType::kI32:
    case ComponentType::kU32:
    case ComponentType::kF64:
      break;
  }
  return {};
}

}  // namespace deltamesh::gltf
