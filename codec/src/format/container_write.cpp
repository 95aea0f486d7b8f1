// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container_write.h"

#include "base/byte_writer.h"
#include "format/container_frame.h"

namespace deltamesh {
namespace {

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
