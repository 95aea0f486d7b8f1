// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container_write.h"

#include "base/byte_writer.h"
#include "format/container_frame.h"

namespace deltamesh {
namespace {

/// Writes what stands before the bytes of chunks, in order.
class ChunkHeaders {
 public:
  explicit ChunkHeaders(const FileHeader& header) : header_(header) {}

  void write_next(ByteWriter& out, const CodedChunk& chunk) {
    write_chunk_header(out, {.tag = chunk.tag,
                             .codec = chunk.codec,
                             .coded_bytes = chunk.bytes.size(),
                             .decoded_bytes = chunk.decoded_bytes});
    if (chunk.tag != kTagAttribute) return;
    const bool is_described = attributes_ < header_.attributes.size();
    write_descriptor(out, is_described ? header_.attributes[attributes_] : AttributeDescriptor{});
    ++attributes_;
  }

 private:
  const FileHeader& header_;
  std::size_t attributes_ = 0;  ///< written so far
};

CodedChunk filler_of(std::uint64_t bytes) {
  const auto size = static_cast<std::size_t>(bytes);
  return {.tag = kTagFiller, .bytes = std::vector<std::byte>(size), .decoded_bytes = size};
}

/// Without a filler.
std::uint64_t bytes_of(const FileHeader& header, std::span<const CodedChunk> chunks) {
  ByteWriter headers;
  ChunkHeaders next(header);
  std::uint64_t bytes = write_header(header).size() + kChecksumBytes;
  for (const CodedChunk& chunk : chunks) {
    next.write_next(headers, chunk);
    bytes += chunk.bytes.size();
  }
  return bytes + headers.size();
}

}  // namespace

std::uint64_t container_bytes(const FileHeader& header, std::span<const CodedChunk> chunks) {
  const std::uint64_t bytes = bytes_of(header, chunks);
  const std::uint64_t least = bytes_needed(header);
  if (bytes >= least) return bytes;
  ByteWriter filler;
  write_chunk_header(filler, {.tag = kTagFiller, .coded_bytes = least - bytes});
  return least + filler.size();
}

std::vector<std::byte> write_container(const FileHeader& header, std::span<const CodedChunk> chunks) {
  ByteWriter out;
  ChunkHeaders next(header);
  const auto add = [&](const CodedChunk& chunk) {
    next.write_next(out, chunk);
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
