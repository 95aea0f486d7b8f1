// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/ply_body.h"

#include <bit>
#include <optional>
#include <string_view>
#include <type_traits>

#include "base/checked.h"
#include "io/components.h"
#include "io/number_text.h"

namespace deltamesh {

Error PlyBody::at(const char* message) const noexcept {
  if (encoding_ == PlyEncoding::kAscii) return text_.error(message);
  return invalid_byte(message, position_);
}

bool PlyBody::may_hold(const PlyElement& element) const noexcept {
  const bool text = encoding_ == PlyEncoding::kAscii;
  std::uint64_t row = 0;  // fewest bytes of a row; in a text a value takes a digit and a blank
  for (const PlyProperty& property : element.properties)
    row += text ? 2 : component_size(property.is_list ? property.count_type : property.type);
  // The last blank of a text may be missing.
  const std::uint64_t present = text ? text_.remaining() + std::uint64_t{1} : bytes_.size() - position_;
  return saturating_mul(row, element.count) <= present;
}

bool PlyBody::next(ComponentType type, double& value) noexcept {
  return encoding_ == PlyEncoding::kAscii ? next_text(type, value) : next_binary(type, value);
}

bool PlyBody::next_text(ComponentType type, double& value) noexcept {
  const std::string_view token = text_.next_token();
  if (token.empty()) {
    problem_ = "PLY: the file ends before its last value";
    return false;
  }
  const std::optional<double> number = parse_number(token);
  std::byte fits[sizeof(double)];
  if (!number || !store_component(type, *number, fits)) {
    problem_ = "PLY: not a number, or one that its type does not hold";
    return false;
  }
  value = *number;
  return true;
}

bool PlyBody::next_binary(ComponentType type, double& value) noexcept {
  const std::size_t size = component_size(type);
  if (bytes_.size() - position_ < size) {
    problem_ = "PLY: the file ends before its last value";
    return false;
  }
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = encoding_ == PlyEncoding::kLittleEndian ? i : size - 1 - i;
    bits |= std::to_integer<std::uint64_t>(bytes_[position_ + i]) << (8 * place);
  }
  position_ += size;
  value = with_component(type, [bits](auto stored) {
    using T = decltype(stored);
    if constexpr (std::is_same_v<T, float>) {
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    } else if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<double>(bits);
    } else {
      return static_cast<double>(static_cast<T>(bits));
    }
  });
  return true;
}

bool PlyBody::skip_row(const PlyElement& element) noexcept {
  double value = 0;
  for (const PlyProperty& property : element.properties) {
    double length = 1;
    if (property.is_list && !next(property.count_type, length)) return false;
    // Every entry takes bytes, so the loop ends with them.
    for (double i = 0; i < length; ++i)
      if (!next(property.type, value)) return false;
  }
  return true;
}

}  // namespace deltamesh
