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

/// Reads each field it visits.
struct FieldReader {
  ByteReader& in;
  template <class T>
  Result<void> fixed(T& field) const {
    DELTAMESH_TRY(field, in.read<T>());
    return {};
  }
  Result<void> short_float(float& field) const {
    DELTAMESH_TRY(field, in.read_short_float());
    return {};
  }
  template <class T>
  Result<void> varint(T& field) const {
    if constexpr (std::is_signed_v<T>) {
      DELTAMESH_TRY(const auto code, in.read_varint());
      field = unzigzag(code);
    } else {
      DELTAMESH_TRY(const auto value, in.read_varint(std::numeric_limits<T>::max()));
      field = static_cast<T>(value);
    }
    return {};
  }
};

/// Writes each field it visits.
struct FieldWriter {
  ByteWriter& out;
  template <class T>
  Result<void> fixed(const T& field) const {
    out.write(field);
    return {};
  }
  Result<void> short_float(float field) const {
    out.write_short_float(field);
    return {};
  }
  template <class T>
  Result<void> varint(const T& field) const {
    if constexpr (std::is_signed_v<T>) {
      out.write_varint(zigzag(std::int64_t{field}));
    } else {
      out.write_varint(field);
    }
    return {};
  }
};

}  // namespace deltamesh
