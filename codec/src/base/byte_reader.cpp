// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_reader.h"

namespace deltamesh {

// None is inlined: many places call them, none of them often.

[[gnu::noinline]] Result<std::uint64_t> ByteReader::read_fixed(std::size_t size) noexcept {
  if (remaining() < size) return error(ErrorCode::kTruncated, "bytes end inside a value", "CON-1");
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value |= std::to_integer<std::uint64_t>(bytes_[position_++]) << (8 * i);
  return value;
}

[[gnu::noinline]] Result<float> ByteReader::read_short_float() noexcept {
  DELTAMESH_TRY(const std::uint64_t value, read_fixed(3));
  return std::bit_cast<float>(static_cast<std::uint32_t>(value << 8));
}

[[gnu::noinline]] Result<std::uint64_t> ByteReader::read_varint(std::uint64_t max) noexcept {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    if (remaining() == 0) return error(ErrorCode::kTruncated, "bytes end inside a value", "CON-1");
    const auto byte = std::to_integer<std::uint64_t>(bytes_[position_++]);
    if (shift == 63 && byte > 1) break;
    value |= (byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) {
      if (byte == 0 && shift != 0) break;
      if (value > max) break;
      return value;
    }
  }
  return invalid("varint too long or out of range", "CON-2");
}

[[gnu::noinline]] Result<std::span<const std::byte>> ByteReader::read_bytes(std::uint64_t size) noexcept {
  if (size > remaining()) return error(ErrorCode::kTruncated, "bytes end inside a value", "CON-1");
  const auto result = bytes_.subspan(position_, static_cast<std::size_t>(size));
  position_ += static_cast<std::size_t>(size);
  return result;
}

[[gnu::noinline]] Result<void> ByteReader::finish() const noexcept {
  if (remaining() != 0) return invalid("bytes left over at the end", "CON-3");
  return {};
}

[[gnu::noinline]] Error ByteReader::error(ErrorCode code, const char* message,
                                          const char* rule) const noexcept {
  return {.code = code,
          .message = message,
          .rule = rule,
          .where_kind = WhereKind::kByte,
          .where = position_,
          .chunk_tag = chunk_tag_};
}

}  // namespace deltamesh
