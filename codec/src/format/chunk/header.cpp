// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/chunk/header.h"

#include "base/checked.h"
#include "format/chunk/kinds.h"

namespace deltamesh {
namespace {

bool is_letter(std::uint32_t c) noexcept { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_tag(std::uint32_t tag) noexcept {
  for (unsigned i = 0; i < 4; ++i) {
    if (!is_letter(tag >> (8 * i) & 0xff)) return false;
  }
  return true;
}

/// Errors: kTruncated, kInvalidStream, kUnsupportedFeature [DIR-2].
Result<std::uint32_t> read_tag(ByteReader& in, unsigned kind) {
  if (kind > kKinds.size())
    return in.error(ErrorCode::kUnsupportedFeature, "a kind of chunk that this library does not know",
                    "DIR-2");
  if (kind != kLetters) return kKinds[kind - 1];
  DELTAMESH_TRY(const auto tag, in.read<std::uint32_t>());
  if (!is_tag(tag)) return in.invalid("a chunk tag is not four letters", "DIR-2");
  if (kind_of(tag) != kLetters) return in.invalid("letters of a tag that has a kind", "DIR-2");
  if (!is_skippable(tag))
    return in.error(ErrorCode::kUnsupportedFeature, "an unknown chunk that may not be skipped", "DIR-2");
  return tag;
}

}  // namespace

void write_chunk_header(ByteWriter& out, const ChunkEntry& entry) {
  const unsigned kind = kind_of(entry.tag);
  out.write(static_cast<std::uint8_t>(kind | static_cast<unsigned>(entry.codec) << kCodecShift));
  if (kind == kLetters) out.write(entry.tag);
  out.write_varint(entry.coded_bytes);
  if (entry.codec == ChunkCodec::kZstd) out.write_varint(entry.decoded_bytes);
}

Result<ChunkEntry> read_chunk_header(ByteReader& in) {
  DELTAMESH_TRY(const auto first, in.read<std::uint8_t>());
  const unsigned codec = first >> kCodecShift;
  if (codec > static_cast<unsigned>(ChunkCodec::kCompact))
    return in.error(ErrorCode::kUnsupportedFeature, "a chunk codec that this library does not know", "DIR-4");
  ChunkEntry entry{.codec = static_cast<ChunkCodec>(codec)};
  DELTAMESH_TRY(entry.tag, read_tag(in, first & kKindMask));
  DELTAMESH_TRY(entry.coded_bytes, in.read_varint());
  entry.decoded_bytes = entry.coded_bytes;
  if (entry.codec != ChunkCodec::kZstd) return entry;
  DELTAMESH_TRY(entry.decoded_bytes, in.read_varint());
  if (entry.decoded_bytes > saturating_mul(entry.coded_bytes, kMaxExpansion))
    return in.invalid("a chunk's two lengths cannot both be", "DIR-5");
  return entry;
}

}  // namespace deltamesh
