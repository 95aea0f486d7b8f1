// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Checked reads from bytes that nobody vouches for. The only place where input bytes are addressed.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "base/try.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Reads little-endian numbers and varints, and short floats [CON-1, CON-2, CON-6] off the front of a byte
/// span; never past its end.
class ByteReader {
 public:
  /// `chunk_tag` is named in errors.
  explicit ByteReader(std::span<const std::byte> bytes, std::uint32_t chunk_tag = 0) noexcept
      : bytes_(bytes), chunk_tag_(chunk_tag) {}

  std::size_t position() const noexcept { return position_; }
  std::size_t remaining() const noexcept { return bytes_.size() - position_; }

  /// Fixed-width little-endian integer or IEEE 754 float. Errors: kTruncated [CON-1].
  template <class T>
  Result<T> read() noexcept {
    static_assert(std::is_arithmetic_v<T>);
    DELTAMESH_TRY(const std::uint64_t value, read_fixed(sizeof(T)));
    if constexpr (std::is_same_v<T, float>) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(value));
    } else if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<double>(value);
    } else {
      return static_cast<T>(value);
    }
  }

  /// A short float. Errors: kTruncated [CON-1].
  Result<float> read_short_float() noexcept;

  /// LEB128, at most 10 bytes, shortest form only, value at most `max`. Errors: kTruncated [CON-1],
  /// kInvalidStream [CON-2].
  Result<std::uint64_t> read_varint(std::uint64_t max = ~std::uint64_t{0}) noexcept;

  /// The next `size` bytes. Errors: kTruncated [CON-1].
  Result<std::span<const std::byte>> read_bytes(std::uint64_t size) noexcept;

  /// Every payload is read to its last byte. Errors: kInvalidStream [CON-3].
  Result<void> finish() const noexcept;

  /// An error at the current position.
  Error error(ErrorCode code, const char* message, const char* rule) const noexcept;
  /// The same, kInvalidStream.
  Error invalid(const char* message, const char* rule) const noexcept {
    return error(ErrorCode::kInvalidStream, message, rule);
  }

 private:
  /// The next `size` bytes, 8 at most, as a number. Errors: kTruncated [CON-1].
  Result<std::uint64_t> read_fixed(std::size_t size) noexcept;

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  std::uint32_t chunk_tag_ = 0;
};

}  // namespace deltamesh
