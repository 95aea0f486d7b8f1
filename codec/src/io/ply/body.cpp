// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/ply/body.h"

#include <optional>

#include "base/checked.h"
#include "io/components.h"
#include "io/text/numbers.h"

namespace deltamesh {
bool PlyBody::may_hold(const PlyElement& element) const noexcept {
  const bool text = encoding_ == PlyEncoding::kAscii;
  std::uint64_t row = 0;  // fewest bytes of a row; in a text a value takes a digit and a blank
  for (const PlyProperty& property : element.properties)
    row += text ? 2 : component_size(property.is_list ? property.count_type : property.type);
  // The last blank of a text may be missing.
  const std::uint64_t present = text ? text_.remaining() + std::uint64_t{1} : bytes_.size() - position_;
  return saturating_mul(row, element.count) <= present;
}

Result<std::uint64_t> PlyBody::end() noexcept {
  if (encoding_ != PlyEncoding::kAscii) return std::uint64_t{bytes_.size() - position_};
  const std::string_view token = text_.next_token();
  if (!token.empty()) return text_.error("PLY: the file goes on behind the elements that it states", token);
  return std::uint64_t{0};
}

Error PlyBody::at(const char* message) const noexcept {
  if (encoding_ == PlyEncoding::kAscii) return text_.error(message, found_);
  return invalid_byte(message, position_);
}

bool PlyBody::next_text(ComponentType type, double& value) noexcept {
  found_ = text_.next_token();
  if (found_.empty()) {
    problem_ = kShort;
    return false;
  }
  const std::optional<double> number = parse_number(found_);
  std::byte fits[sizeof(double)];
  if (!number || !store_component(type, *number, fits)) {
    problem_ = "PLY: not a number, or one that its type does not hold";
    return false;
  }
  value = *number;
  return true;
}

}  // namespace deltamesh
