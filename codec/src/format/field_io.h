// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Visitors of header_fields.h that read and write.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"

namespace deltamesh {

/// Reads each field it visits, up to the first error: fields from there on stay as they are.
class FieldReader {
 public:
  explicit FieldReader(ByteReader& in) noexcept : in_(in) {}

  template <class T>
  void fixed(T& field) {
    if (first_) take(in_.read<T>(), field);
  }
  void short_float(float& field) {
    if (first_) take(in_.read_short_float(), field);
  }
  /// A number that T does not hold becomes the largest: the rule of the field tells whether it may be so
  /// large.
  template <class T>
  void varint(T& field) {
    constexpr bool kIsSigned = std::is_signed_v<T>;
    if (!first_) return;
    const auto code = in_.read_varint();
    if (!code) {
      first_ = code.error();
    } else if constexpr (kIsSigned) {
      field = unzigzag(*code);
    } else {
      field = static_cast<T>(std::min<std::uint64_t>(*code, std::numeric_limits<T>::max()));
    }
  }

  /// The first error, if there was one.
  const Result<void>& outcome() const noexcept { return first_; }

 private:
  template <class T>
  void take(Result<T> read, T& field) {
    if (read) {
      field = *read;
    } else {
      first_ = read.error();
    }
  }

  ByteReader& in_;
  Result<void> first_;
};

/// Writes each field it visits.
class FieldWriter {
 public:
  explicit FieldWriter(ByteWriter& out) noexcept : out_(out) {}

  template <class T>
  void fixed(const T& field) {
    out_.write(field);
  }
  void short_float(float field) { out_.write_short_float(field); }
  template <class T>
  void varint(const T& field) {
    if constexpr (std::is_signed_v<T>) {
      out_.write_varint(zigzag(std::int64_t{field}));
    } else {
      out_.write_varint(field);
    }
  }

 private:
  ByteWriter& out_;
};

}  // namespace deltamesh
