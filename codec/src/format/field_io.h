// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Visitors of header_fields.h that read and write.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/try.h"
#include "base/zigzag.h"

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
  template <class T>
  void varint(T& field) {
    std::uint64_t code = 0;
    if constexpr (std::is_signed_v<T>) {
      take_varint(std::numeric_limits<std::uint64_t>::max(), code);
      if (first_) field = unzigzag(code);
    } else {
      take_varint(std::numeric_limits<T>::max(), code);
      if (first_) field = static_cast<T>(code);
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
  void take_varint(std::uint64_t most, std::uint64_t& code) {
    if (first_) take(in_.read_varint(most), code);
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
