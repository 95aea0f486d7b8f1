// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What follows the header of a PLY file: rows of values, as text or binary.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/component.h"
#include "io/ply/header.h"
#include "io/text/scanner.h"

namespace deltamesh {

class PlyBody {
 public:
  /// `bytes`: the whole file.
  PlyBody(std::span<const std::byte> bytes, const PlyHeader& header) noexcept
      : bytes_(bytes),
        position_(header.data_offset),
        text_(as_text(bytes.subspan(header.data_offset)), {}, header.data_line),
        encoding_(header.encoding) {}

  /// `take(property, value)` for every value of a row of `element`, exact; it returns what is wrong with the
  /// value, or null. Errors: kInvalidFile: the bytes end, a text is not a number that its type holds, a row
  /// of a text has more values.
  template <class Take>
  Result<void> read_row(const PlyElement& element, Take take) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double length = 1;
      if (property.is_list) {
        if (!next(property.count_type, length)) return at(problem_);
        if (!(length >= 0) || length != static_cast<double>(static_cast<std::int64_t>(length)))
          return at("PLY: the length of a list is negative or no whole number");
      }
      // Every entry takes bytes, so the loop ends with them.
      for (double i = 0; i < length; ++i) {
        double value = 0;
        if (!next(property.type, value)) return at(problem_);
        if (const char* const wrong = take(p, value)) return at(wrong);
      }
    }
    if (encoding_ != PlyEncoding::kAscii) return {};
    found_ = {};
    return text_.end_line("PLY: a row has more values than its element has properties");
  }

  /// Whether `element.count` rows can be in the bytes that are left: the check before anything is allocated.
  bool may_hold(const PlyElement& element) const noexcept;

  /// Bytes of a binary file behind the last row. Errors: kInvalidFile: a text goes on there.
  Result<std::uint64_t> end() noexcept;

  /// `message` at the present place: the line and last word of a text, else the byte.
  Error at(const char* message) const noexcept;

 private:
  /// The next value. False where there is none: problem_ tells why.
  bool next(ComponentType type, double& value) noexcept {
    return encoding_ == PlyEncoding::kAscii ? next_text(type, value) : next_binary(type, value);
  }
  bool next_text(ComponentType type, double& value) noexcept;
  bool next_binary(ComponentType type, double& value) noexcept {
    const std::size_t size = component_size(type);
    if (bytes_.size() - position_ < size) {
      problem_ = kShort;
      return false;
    }
    const std::byte* const from = bytes_.data() + position_;
    position_ += size;
    if (encoding_ == PlyEncoding::kLittleEndian) {
      value = load_component(type, from);
    } else {
      std::array<std::byte, sizeof(double)> swapped;
      std::reverse_copy(from, from + size, swapped.begin());
      value = load_component(type, swapped.data());
    }
    return true;
  }

  static constexpr const char* kShort = "PLY: the file ends before its last value";

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;  // binary encodings
  TextScanner text_;          // kAscii
  std::string_view found_;    // the last word of it
  PlyEncoding encoding_;
  const char* problem_ = "";
};

}  // namespace deltamesh
