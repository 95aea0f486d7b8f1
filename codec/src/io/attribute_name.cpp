// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/attribute_name.h"

#include <cstddef>
#include <cstdint>

#include "format/chunk/attribute_descriptor.h"

namespace deltamesh {
namespace {

/// Bytes of the UTF-8 character at the front of `text`; 0 where it is malformed.
std::size_t character_size(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const std::uint8_t second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool surrogate = first == 0xed && second >= 0xa0;
  const bool too_large = first == 0xf4 && second >= 0x90;
  return overlong || surrogate || too_large ? 0 : size;
}

}  // namespace

bool is_attribute_name(std::string_view name) noexcept {
  if (name.empty() || name.size() > kMaxAttributeName) return false;
  while (!name.empty()) {
    const std::size_t size = character_size(name);
    if (size == 0) return false;
    name.remove_prefix(size);
  }
  return true;
}

}  // namespace deltamesh
