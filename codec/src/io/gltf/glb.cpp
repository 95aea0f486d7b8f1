// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/glb.h"

#include <limits>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "io/io_error.h"

namespace deltamesh::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;     // "glTF"
constexpr std::uint32_t kJsonType = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t kBinType = 0x004e4942;   // "BIN"
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

constexpr std::size_t padded(std::size_t size) noexcept { return (size + 3) / 4 * 4; }

void write_chunk(ByteWriter& out, std::uint32_t type, std::span<const std::byte> bytes, std::byte filler) {
  out.write(static_cast<std::uint32_t>(padded(bytes.size())));
  out.write(type);
  out.write_bytes(bytes);
  for (std::size_t i = bytes.size(); i < padded(bytes.size()); ++i) out.write_bytes({&filler, 1});
}

}  // namespace

bool is_glb(std::span<const std::byte> file) noexcept {
  const auto magic = ByteReader(file).read<std::uint32_t>();
  return magic && *magic == kMagic;
}

Result<Glb> parse_glb(std::span<const std::byte> file) {
  if (file.size() < kHeaderSize) return invalid_byte("GLB ends inside its header", file.size());
  ByteReader in(file);
  DELTAMESH_TRY(const auto magic, in.read<std::uint32_t>());
  if (magic != kMagic) return invalid_byte("not a GLB file", 0);
  DELTAMESH_TRY(const auto version, in.read<std::uint32_t>());
  if (version != kVersion) return invalid_byte("GLB of another version than 2", 4);
  DELTAMESH_TRY(const auto length, in.read<std::uint32_t>());
  if (length > file.size()) return invalid_byte("GLB is shorter than its header says", 8);

  Glb glb;
  for (std::size_t number = 0; in.position() < length; ++number) {
    const std::size_t start = in.position();
    if (length - start < kChunkHeaderSize) return invalid_byte("GLB ends inside a chunk header", start);
    DELTAMESH_TRY(const auto size, in.read<std::uint32_t>());
    DELTAMESH_TRY(const auto type, in.read<std::uint32_t>());
    if (size > length - in.position()) return invalid_byte("GLB ends inside a chunk", start);
    DELTAMESH_TRY(const auto bytes, in.read_bytes(size));
    if (number == 0) {
      if (type != kJsonType) return invalid_byte("the first chunk of a GLB must be JSON", start);
      glb.json = bytes;
    } else if (type == kBinType && number == 1) {
      glb.bin = bytes;
    } else if (type == kBinType || type == kJsonType) {
      return invalid_byte("GLB chunk out of place", start);
    } else {
      glb.others.push_back({type, bytes});
    }
  }
  if (glb.json.empty()) return invalid_byte("GLB without JSON", kHeaderSize);
  return glb;
}

Result<std::vector<std::byte>> write_glb(std::string_view json, std::span<const std::byte> bin,
                                         std::span<const GlbChunk> others) {
  std::size_t size = kHeaderSize + kChunkHeaderSize + padded(json.size());
  if (!bin.empty()) size += kChunkHeaderSize + padded(bin.size());
  for (const GlbChunk& chunk : others) size += kChunkHeaderSize + padded(chunk.bytes.size());
  if (size > std::numeric_limits<std::uint32_t>::max())
    return Error{.code = ErrorCode::kLimitExceeded, .message = "a GLB holds at most 4 GiB"};

  ByteWriter out;
  out.write(kMagic);
  out.write(kVersion);
  out.write(static_cast<std::uint32_t>(size));
  write_chunk(out, kJsonType, std::as_bytes(std::span(json.data(), json.size())), std::byte{' '});
  if (!bin.empty()) write_chunk(out, kBinType, bin, std::byte{0});
  for (const GlbChunk& chunk : others) write_chunk(out, chunk.type, chunk.bytes, std::byte{0});
  return out.take();
}

}  // namespace deltamesh::gltf
