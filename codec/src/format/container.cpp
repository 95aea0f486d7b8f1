// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container.h"

#include <algorithm>

#include "base/byte_writer.h"
#include "format/container_frame.h"

namespace deltamesh {

[[gnu::weak]] bool checksum_holds(std::uint32_t stored, std::uint32_t computed) noexcept {
  return stored == computed;
}

namespace {

/// Of any chunk but those that are skipped [DIR-5].
std::uint64_t longest_payload(const FileHeader& header) noexcept {
  return 1024 + 160 * (std::uint64_t{header.vertices} + header.triangles);
}

/// Whether there is at most one such chunk [DIR-8].
bool is_single(std::uint32_t tag) noexcept { return tag != kTagAttribute && !is_skippable(tag); }

/// What stands before the bytes of a chunk.
void write_head(ByteWriter& out, const CodedChunk& chunk) {
  write_chunk_header(out, {.tag = chunk.tag,
                           .codec = chunk.codec,
                           .coded_bytes = chunk.bytes.size(),
                           .decoded_bytes = chunk.decoded_bytes});
  if (chunk.tag == kTagAttribute) write_descriptor(out, chunk.attribute);
}

CodedChunk filler_of(std::uint64_t bytes) {
  const auto size = static_cast<std::size_t>(bytes);
  return {.tag = kTagFiller, .bytes = std::vector<std::byte>(size), .decoded_bytes = size};
}

}  // namespace

[[gnu::noinline]] Error chunk_error(ErrorCode code, const char* message, const char* rule,
                                    const ChunkEntry& entry) noexcept {
  return {.code = code,
          .message = message,
          .rule = rule,
          .where_kind = WhereKind::kByte,
          .where = entry.offset,
          .chunk_tag = entry.tag};
}

Result<Container> Container::open(std::span<const std::byte> stream) {
  ByteReader signature(stream);
  DELTAMESH_CHECK(read_signature(signature));
  DELTAMESH_TRY(const auto covered,
                check_whole(stream, "the checksum does not match: the stream is damaged or cut off", "CNT-2",
                            checksum_of));
  Container container;
  container.stream_ = stream;
  ByteReader in(covered);
  DELTAMESH_TRY(container.header_, read_header(in));
  if (bytes_needed(container.header_) > stream.size())
    return in.invalid("more vertices and triangles than a stream of this length may hold", "CNT-5");
  while (in.remaining() > 0) {
    if (container.entries_.size() == kMaxChunks) return in.invalid("more than 65536 chunks", "DIR-1");
    DELTAMESH_TRY(ChunkEntry entry, read_chunk_header(in));
    if (!is_skippable(entry.tag) && entry.decoded_bytes > longest_payload(container.header_))
      return in.invalid("the chunk is longer than the header's counts allow", "DIR-5");
    if (entry.tag == kTagAttribute) {
      DELTAMESH_TRY(auto descriptor, read_descriptor(in));
      container.header_.attributes.push_back(std::move(descriptor));
    }
    entry.offset = in.position();
    if (entry.coded_bytes > in.remaining())
      return in.error(ErrorCode::kTruncated, "bytes end inside a chunk", "DIR-7");
    if (is_single(entry.tag) && container.find(entry.tag) != nullptr)
      return in.invalid("the chunk appears twice", "DIR-8");
    DELTAMESH_TRY([[maybe_unused]] const auto bytes, in.read_bytes(entry.coded_bytes));
    container.entries_.push_back(entry);
  }
  return container;
}

std::span<const std::byte> Container::coded(const ChunkEntry& entry) const noexcept {
  return stream_.subspan(static_cast<std::size_t>(entry.offset), static_cast<std::size_t>(entry.coded_bytes));
}

const ChunkEntry* Container::find(std::uint32_t tag) const noexcept {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [tag](const ChunkEntry& entry) { return entry.tag == tag; });
  return found == entries_.end() ? nullptr : &*found;
}

std::uint64_t stored_bytes(const CodedChunk& chunk) {
  ByteWriter head;
  write_head(head, chunk);
  return head.size() + chunk.bytes.size();
}

std::uint64_t stream_bytes(const FileHeader& header, std::uint64_t chunk_bytes) {
  const std::uint64_t bytes = write_header(header).size() + chunk_bytes + kChecksumBytes;
  const std::uint64_t least = bytes_needed(header);
  if (bytes >= least) return bytes;
  ByteWriter filler;
  write_chunk_header(filler, {.tag = kTagFiller, .coded_bytes = least - bytes});
  return least + filler.size();
}

std::vector<std::byte> write_container(const FileHeader& header, std::span<const CodedChunk> chunks) {
  ByteWriter out;
  const auto add = [&](const CodedChunk& chunk) {
    write_head(out, chunk);
    out.write_bytes(chunk.bytes);
  };
  out.write_bytes(write_header(header));
  for (const CodedChunk& chunk : chunks) add(chunk);
  const std::uint64_t bytes = out.size() + kChecksumBytes;
  if (const std::uint64_t least = bytes_needed(header); bytes < least) add(filler_of(least - bytes));
  out.write(checksum_of(out.bytes()));
  return out.take();
}

}  // namespace deltamesh
