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
    if (remaining() < sizeof(T)) return error(ErrorCode::kTruncated, "bytes end inside a number", "CON-1");
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value |= std::to_integer<std::uint64_t>(bytes_[position_ + i]) << (8 * i);
    position_ += sizeof(T);
    if constexpr (std::is_same_v<T, float>) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(value));
    } else if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<double>(value);
    } else {
      return static_cast<T>(value);
    }
  }

  /// A short float. Errors: kTruncated [CON-1].
  Result<float> read_short_float() noexcept {
    if (remaining() < 3) return error(ErrorCode::kTruncated, "bytes end inside a number", "CON-1");
    std::uint32_t bits = 0;
    for (unsigned i = 1; i < 4; ++i) bits |= std::to_integer<std::uint32_t>(bytes_[position_++]) << (8 * i);
    return std::bit_cast<float>(bits);
  }

  /// LEB128, at most 10 bytes, shortest form only, value at most `max`. Errors: kTruncated, kInvalidStream
  /// [CON-2].
  Result<std::uint64_t> read_varint(std::uint64_t max = ~std::uint64_t{0}) noexcept {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      if (remaining() == 0) return error(ErrorCode::kTruncated, "bytes end inside a varint", "CON-2");
      const auto byte = std::to_integer<std::uint64_t>(bytes_[position_++]);
      if (shift == 63 && byte > 1) break;
      value |= (byte & 0x7f) << shift;
      if ((byte & 0x80) == 0) {
        if (byte == 0 && shift != 0) break;
        if (value > max) break;
        return value;
      }
    }
    return error(ErrorCode::kInvalidStream, "varint too long or out of range", "CON-2");
  }

  /// The next `size` bytes. Errors: kTruncated [CON-1].
  Result<std::span<const std::byte>> read_bytes(std::uint64_t size) noexcept {
    if (size > remaining()) return error(ErrorCode::kTruncated, "bytes end inside an array", "CON-1");
    const auto result = bytes_.subspan(position_, static_cast<std::size_t>(size));
    position_ += static_cast<std::size_t>(size);
    return result;
  }

  /// Every payload is read to its last byte. Errors: kInvalidStream [CON-3].
  Result<void> finish() const noexcept {
    if (remaining() != 0) return error(ErrorCode::kInvalidStream, "bytes left over at the end", "CON-3");
    return {};
  }

  /// An error at the current position.
  [[gnu::noinline]] Error error(ErrorCode code, const char* message, const char* rule) const noexcept {
    return {.code = code,
            .message = message,
            .rule = rule,
            .where_kind = WhereKind::kByte,
            .where = position_,
            .chunk_tag = chunk_tag_};
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  std::uint32_t chunk_tag_ = 0;
};

}  // namespace deltamesh
