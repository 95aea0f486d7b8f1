// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container.h"

#include <xxhash.h>

#include "base/byte_writer.h"

namespace deltamesh {
namespace {

constexpr std::size_t kAlignment = 8;             // [CNT-3]
constexpr std::uint64_t kElementsPerByte = 2048;  // [CNT-5]

std::uint64_t checksum_of(std::span<const std::byte> bytes) noexcept {
  return XXH3_64bits(bytes.data(), bytes.size());
}

bool matches(std::uint64_t stored, std::span<const std::byte> bytes) noexcept {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  (void)stored,
      (void)bytes;  // a fuzzer cannot guess checksums, and what lies behind them must be safe on its own
  return true;
#else
  return stored == checksum_of(bytes);
#endif
}

void pad(ByteWriter& out) {
  while (out.size() % kAlignment != 0) out.write(std::uint8_t{0});
}

Result<void> skip_padding(ByteReader& in) {
  while (in.position() % kAlignment != 0) {
    DELTAMESH_TRY(const auto byte, in.read<std::uint8_t>());
    if (byte != 0) return in.error(ErrorCode::kInvalidStream, "padding is not zero", "CNT-3");
  }
  return {};
}

bool is_known(std::uint32_t tag) noexcept {
  return tag == kTagConnectivity || tag == kTagSeams || tag == kTagOrder || tag == kTagDeltas ||
         tag == kTagAnchors || tag == kTagPositions || tag == kTagAttribute;
}

/// The stream length that [CNT-5] asks for.
std::uint64_t bytes_needed(const FileHeader& header) noexcept {
  const std::uint64_t elements = std::uint64_t{header.vertices} + header.triangles;
  return (elements + kElementsPerByte - 1) / kElementsPerByte;
}

std::vector<std::byte> write_chunks(const FileHeader& header, std::span<const CodedChunk> chunks) {
  ByteWriter out;
  out.write_bytes(write_header(header));
  std::vector<ChunkEntry> entries;
  for (const CodedChunk& chunk : chunks) {
    entries.push_back({.tag = chunk.tag,
                       .codec = chunk.codec,
                       .coded_bytes = chunk.bytes.size(),
                       .decoded_bytes = chunk.decoded_bytes,
                       .checksum = checksum_of(chunk.bytes)});
  }
  write_directory(out, entries);
  out.write(checksum_of(out.bytes()));
  for (const CodedChunk& chunk : chunks) {
    pad(out);
    out.write_bytes(chunk.bytes);
  }
  return out.take();
}

}  // namespace

Error chunk_error(ErrorCode code, const char* message, const char* rule, const ChunkEntry& entry) noexcept {
  return {.code = code,
          .message = message,
          .rule = rule,
          .where_kind = WhereKind::kByte,
          .where = entry.offset,
          .chunk_tag = entry.tag};
}

std::vector<std::byte> write_container(const FileHeader& header, std::span<const CodedChunk> chunks) {
  const std::uint64_t least = bytes_needed(header);
  auto stream = write_chunks(header, chunks);
  if (stream.size() >= least) return stream;
  std::vector<CodedChunk> filled(chunks.begin(), chunks.end());
  const auto filler = static_cast<std::size_t>(least - stream.size());
  filled.push_back({.tag = kTagFiller, .bytes = std::vector<std::byte>(filler), .decoded_bytes = filler});
  return write_chunks(header, filled);
}

Result<Container> Container::open(std::span<const std::byte> stream) {
  Container container;
  container.stream_ = stream;
  ByteReader in(stream);
  DELTAMESH_TRY(container.header_, read_header(in));
  if (bytes_needed(container.header_) > stream.size())
    return in.error(ErrorCode::kInvalidStream,
                    "more vertices and triangles than a stream of this length may hold", "CNT-5");
  DELTAMESH_TRY(container.entries_, read_directory(in));
  const auto covered = stream.first(in.position());
  DELTAMESH_TRY(const auto stored, in.read<std::uint64_t>());
  if (!matches(stored, covered))
    return in.error(ErrorCode::kCorrupt, "the checksum of header and directory does not match", "CNT-2");
  for (ChunkEntry& entry : container.entries_) {
    DELTAMESH_CHECK(skip_padding(in));
    entry.offset = in.position();
    if (entry.coded_bytes > in.remaining())
      return in.error(ErrorCode::kTruncated, "bytes end inside a chunk", "DIR-7");
    DELTAMESH_TRY([[maybe_unused]] const auto bytes, in.read_bytes(entry.coded_bytes));
    if (!is_known(entry.tag) && !is_skippable(entry.tag))
      return in.error(ErrorCode::kUnsupportedFeature, "an unknown chunk that may not be skipped", "DIR-2");
  }
  if (in.remaining() != 0) return in.error(ErrorCode::kInvalidStream, "bytes after the last chunk", "CNT-4");
  return container;
}

std::span<const std::byte> Container::coded(const ChunkEntry& entry) const noexcept {
  return stream_.subspan(static_cast<std::size_t>(entry.offset), static_cast<std::size_t>(entry.coded_bytes));
}

Result<void> Container::check(const ChunkEntry& entry) const noexcept {
  if (!matches(entry.checksum, coded(entry)))
    return chunk_error(ErrorCode::kCorrupt, "the chunk's checksum does not match", "DIR-6", entry);
  return {};
}

Result<const ChunkEntry*> Container::find(std::uint32_t tag) const {
  const ChunkEntry* found = nullptr;
  for (const ChunkEntry& entry : entries_) {
    if (entry.tag != tag) continue;
    if (found != nullptr)
      return chunk_error(ErrorCode::kInvalidStream, "the chunk appears twice", "DIR-8", entry);
    found = &entry;
  }
  return found;
}

}  // namespace deltamesh
