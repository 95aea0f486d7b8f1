// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/container.h"

#include <xxhash.h>

#include <utility>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/try.h"
#include "format/container.h"
#include "format/container_frame.h"
#include "format/field_io.h"
#include "format/header.h"
#include "format/header_fields.h"
#include "part/header.h"
#include "support/limits.h"

namespace deltamesh {
namespace {

Error broken_part(const ByteReader& in, const char* message) noexcept {
  return in.error(ErrorCode::kInvalidStream, message, "MAP-7");
}

/// That the part takes at least, without its checksum; what the base has as well needs none.
std::uint64_t bytes_needed(const PartPlace& place, const FileHeader& header) noexcept {
  const std::uint64_t elements = std::uint64_t{header.vertices} + header.triangles;
  const std::uint64_t own = elements - std::min(elements, place.known_elements);
  return (own + kPartElementsPerByte - 1) / kPartElementsPerByte;
}

/// The part's bytes before its checksum, which is checked.
Result<std::span<const std::byte>> check_part(const PartPlace& place, std::span<const std::byte> bytes) {
  if (bytes.size() > kMostPartOctets)
    return Error{
        .code = ErrorCode::kInvalidStream, .message = "a part of more than 65536 bytes", .rule = "MAP-7"};
  const auto checksum = [&](std::span<const std::byte> covered) { return part_checksum(place, covered); };
  return check_whole(bytes, "the checksum does not match: damaged, or another part, map or epoch", "MAP-7",
                     checksum);
}

/// Whether `flags` are those of a part that is not the primer.
bool are_flags_valid(const PartPlace& place, std::uint8_t flags) noexcept {
  if ((flags & (kFlagPrimer | kFlagBits)) != 0 || are_reserved_flags_set(flags)) return false;
  if ((flags & kFlagGrid) == 0) return true;
  constexpr unsigned kOfLattices = kFlagLongSteps | kFlagThreeSteps | kFlagLatticeOrigin;
  return place.description.grid && (flags & kOfLattices) == 0 &&
         static_cast<Geometry>(flags >> kGeometryShift) == Geometry::kVoxel;
}

Result<FileHeader> read_part_header(const PartPlace& place, std::uint8_t flags, ByteReader& in) {
  if (!are_flags_valid(place, flags)) return broken_part(in, "a flag that means nothing in this part");
  FileHeader header;
  apply_flags(flags, header);
  header.keeps_order = false;
  FieldReader fields(in);
  visit_part_header(fields, flags, place, header);
  DELTAMESH_CHECK(fields.outcome());
  DELTAMESH_CHECK(check_header(header, in));
  return header;
}

CodedChunk read_bytes_of(const ChunkEntry& entry, std::span<const std::byte> bytes) {
  return {.tag = entry.tag,
          .codec = entry.codec,
          .bytes = {bytes.begin(), bytes.end()},
          .decoded_bytes = entry.decoded_bytes};
}

Result<std::vector<CodedChunk>> read_chunks(const PartPlace& place, ByteReader& in) {
  std::vector<CodedChunk> chunks;
  std::size_t attributes = 0;
  const auto& shapes = place.description.attributes;
  while (in.remaining() > 0) {
    DELTAMESH_TRY(const ChunkEntry entry, read_chunk_header(in));
    DELTAMESH_TRY(const auto bytes, in.read_bytes(entry.coded_bytes));
    if (entry.tag == kTagOrder) return broken_part(in, "a part has no order to restore");
    CodedChunk chunk = read_bytes_of(entry, bytes);
    if (entry.tag == kTagAttribute) {
      if (attributes == shapes.size()) return broken_part(in, "more attributes than the map has");
      chunk.attribute = descriptor_of(shapes[attributes++]);
    }
    if (entry.tag != kTagFiller) chunks.push_back(std::move(chunk));
  }
  if (attributes != shapes.size()) return broken_part(in, "fewer attributes than the map has");
  return chunks;
}

void write_chunk(ByteWriter& out, const ChunkEntry& entry, std::span<const std::byte> bytes) {
  write_chunk_header(out, entry);
  out.write_bytes(bytes);
}

}  // namespace

std::uint32_t part_checksum(const PartPlace& place, std::span<const std::byte> bytes) {
  ByteWriter key;
  key.write(place.description_hash);
  key.write(place.key.level);
  for (const std::int32_t x : {place.key.x, place.key.y, place.key.z}) key.write(x);
  const std::uint64_t seed = XXH3_64bits(key.bytes().data(), key.size());
  return static_cast<std::uint32_t>(XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed));
}

Result<std::vector<std::byte>> write_part(const PartPlace& place, std::span<const std::byte> stream,
                                          std::span<const std::byte> border) {
  DELTAMESH_TRY(const Container container, Container::open(stream));
  FileHeader header = container.header();
  header.highpass.bits = header.predictive.bits = 0;
  ByteWriter out;
  constexpr unsigned kOfLattices = kFlagLongSteps | kFlagThreeSteps | kFlagLatticeOrigin;
  std::uint8_t flags = flags_of(header);
  if (is_on_grid(place, header)) flags = static_cast<std::uint8_t>((flags & ~kOfLattices) | kFlagGrid);
  out.write(flags);
  FieldWriter fields(out);
  visit_part_header(fields, flags, place, std::as_const(header));
  out.write_varint(border.size());
  out.write_bytes(border);
  for (const ChunkEntry& entry : container.entries())
    if (entry.tag != kTagFiller) write_chunk(out, entry, container.coded(entry));
  const std::uint64_t needed = bytes_needed(place, header);
  if (out.size() < needed) {
    const std::vector<std::byte> filler(static_cast<std::size_t>(needed - out.size()));
    write_chunk(out, {.tag = kTagFiller, .coded_bytes = filler.size()}, filler);
  }
  out.write(part_checksum(place, out.bytes()));
  return out.take();
}

std::vector<std::byte> write_primer_part(const PartPlace& place, std::size_t primer) {
  ByteWriter out;
  out.write(kFlagPrimer);
  out.write(static_cast<std::uint8_t>(primer));
  out.write(part_checksum(place, out.bytes()));
  return out.take();
}

std::optional<std::size_t> primer_of(std::span<const std::byte> octets) noexcept {
  if (octets.size() < 2 || octets.front() != std::byte{kFlagPrimer}) return std::nullopt;
  return std::to_integer<std::size_t>(octets[1]);
}

Result<OpenedPart> open_part(const PartPlace& place, std::span<const std::byte> bytes) {
  DELTAMESH_TRY(const auto covered, check_part(place, bytes));
  return open_covered_part(place, covered);
}

Result<OpenedPart> open_covered_part(const PartPlace& place, std::span<const std::byte> covered) {
  ByteReader in(covered);
  DELTAMESH_TRY(const auto flags, in.read<std::uint8_t>());
  if (flags == kFlagPrimer) {
    DELTAMESH_TRY(const auto number, in.read<std::uint8_t>());
    if (number >= place.description.primers.size())
      return broken_part(in, "a primer that the map does not have");
    DELTAMESH_CHECK(in.finish());
    const MapPrimer& primer = place.description.primers[number];
    return OpenedPart{primer.stream, number, primer.border};
  }
  DELTAMESH_TRY(const FileHeader header, read_part_header(place, flags, in));
  if (bytes_needed(place, header) > covered.size())
    return broken_part(in, "more vertices and triangles than a part of this length may hold");
  DELTAMESH_TRY(const auto border_size, in.read_varint());
  DELTAMESH_TRY(const auto border, in.read_bytes(border_size));
  DELTAMESH_TRY(const auto chunks, read_chunks(place, in));
  return OpenedPart{write_container(header, chunks), std::nullopt, {border.begin(), border.end()}};
}

}  // namespace deltamesh
