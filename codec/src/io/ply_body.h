// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The values of a PLY file one after the other, whatever their encoding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "io/ply_header.h"
#include "io/text_scanner.h"

namespace deltamesh {

class PlyBody {
 public:
  /// `bytes`: the whole file.
  PlyBody(std::span<const std::byte> bytes, const PlyHeader& header) noexcept
      : bytes_(bytes),
        position_(header.data_offset),
        text_(as_text(bytes.subspan(header.data_offset)), false, header.data_line),
        encoding_(header.encoding) {}

  /// The next value, exact. False where the bytes end, or a text is not a number that `type` holds: see
  /// error().
  bool next(ComponentType type, double& value) noexcept;

  /// Skips one row of `element`. False as next().
  bool skip_row(const PlyElement& element) noexcept;

  /// Whether `element.count` rows can be in the bytes that are left: the check before anything is allocated.
  bool may_hold(const PlyElement& element) const noexcept;

  /// What stopped next(), and where.
  Error error() const noexcept { return at(problem_); }
  /// `message` at the present place: the line in a text, else the byte.
  Error at(const char* message) const noexcept;

 private:
  bool next_text(ComponentType type, double& value) noexcept;
  bool next_binary(ComponentType type, double& value) noexcept;

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;  // binary encodings
  TextScanner text_;          // kAscii
  PlyEncoding encoding_;
  const char* problem_ = "";
};

}  // namespace deltamesh
