// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/directory.h"

#include "base/checked.h"

namespace deltamesh {
namespace {

constexpr std::uint64_t kSmallestEntry = 4 + 1 + 1 + 1 + 1 + 8;

bool is_letter(std::uint32_t c) noexcept { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_tag(std::uint32_t tag) noexcept {
  for (unsigned i = 0; i < 4; ++i) {
    if (!is_letter(tag >> (8 * i) & 0xff)) return false;
  }
  return true;
}

Result<ChunkEntry> read_entry(ByteReader& in) {
  ChunkEntry entry;
  DELTAMESH_TRY(entry.tag, in.read<std::uint32_t>());
  if (!is_tag(entry.tag))
    return in.error(ErrorCode::kInvalidStream, "a chunk tag is not four letters", "DIR-2");
  DELTAMESH_TRY(const auto part, in.read_varint());
  if (part != 0) return in.error(ErrorCode::kUnsupportedFeature, "a part number other than 0", "DIR-3");
  DELTAMESH_TRY(const auto codec, in.read<std::uint8_t>());
  if (codec > static_cast<std::uint8_t>(ChunkCodec::kCompact))
    return in.error(ErrorCode::kUnsupportedFeature, "a chunk codec that this library does not know", "DIR-4");
  entry.codec = static_cast<ChunkCodec>(codec);
  DELTAMESH_TRY(entry.coded_bytes, in.read_varint());
  DELTAMESH_TRY(entry.decoded_bytes, in.read_varint());
  const bool plausible = entry.codec != ChunkCodec::kZstd
                             ? entry.decoded_bytes == entry.coded_bytes
                             : entry.decoded_bytes <= saturating_mul(entry.coded_bytes, kMaxExpansion);
  if (!plausible) return in.error(ErrorCode::kInvalidStream, "a chunk's two lengths cannot both be", "DIR-5");
  DELTAMESH_TRY(entry.checksum, in.read<std::uint64_t>());
  return entry;
}

}  // namespace

void write_directory(ByteWriter& out, std::span<const ChunkEntry> entries) {
  out.write_varint(entries.size());
  for (const ChunkEntry& entry : entries) {
    out.write(entry.tag);
    out.write_varint(entry.part);
    out.write(static_cast<std::uint8_t>(entry.codec));
    out.write_varint(entry.coded_bytes);
    out.write_varint(entry.decoded_bytes);
    out.write(entry.checksum);
  }
}

Result<std::vector<ChunkEntry>> read_directory(ByteReader& in) {
  DELTAMESH_TRY(const auto count, in.read_varint(kMaxChunks));
  if (count > in.remaining() / kSmallestEntry)
    return in.error(ErrorCode::kTruncated, "bytes end inside the directory", "DIR-1");
  std::vector<ChunkEntry> entries;
  entries.reserve(static_cast<std::size_t>(count));
  for (std::uint64_t i = 0; i < count; ++i) {
    DELTAMESH_TRY(const auto entry, read_entry(in));
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace deltamesh
