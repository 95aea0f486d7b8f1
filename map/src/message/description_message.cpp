// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <xxhash.h>

#include <limits>
#include <optional>
#include <span>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "deltamesh/map/description.h"
#include "format/chunk/attribute_descriptor.h"
#include "message/frame.h"
#include "support/limits.h"

namespace deltamesh {
namespace {

void write_text(ByteWriter& out, const std::string& text) {
  out.write(static_cast<std::uint8_t>(text.size()));
  out.write_bytes(std::as_bytes(std::span(text)));
}

Result<std::string> read_text(ByteReader& in) {
  DELTAMESH_TRY(const auto size, in.read<std::uint8_t>());
  DELTAMESH_TRY(const auto letters, in.read_bytes(size));
  std::string text;
  for (const std::byte letter : letters) text += static_cast<char>(letter);
  return text;
}

/// Only the shortest form is valid, so that a description has one message and one hash.
Result<MapAttribute> read_attribute(ByteReader& in) {
  const std::size_t start = in.position();
  DELTAMESH_TRY(auto descriptor, read_descriptor(in));
  if (descriptor.error != 0)
    return in.error(ErrorCode::kInvalidStream, "an attribute of a map has no error", "MAP-5");
  ByteWriter shortest;
  write_descriptor(shortest, descriptor);
  if (in.position() - start != shortest.size())
    return in.error(ErrorCode::kInvalidStream, "an attribute's descriptor that is longer than it need be",
                    "MAP-5");
  return MapAttribute{.kind = descriptor.kind,
                      .type = descriptor.type,
                      .components = descriptor.components,
                      .normalized = descriptor.is_normalized(),
                      .name = std::move(descriptor.name),
                      .linear = descriptor.is_linear()};
}

std::vector<std::byte> message_of(const MapDescription& description) {
  ByteWriter out = begin_message(MessageKind::kMap);
  out.write(description.id);
  out.write(description.epoch);
  write_text(out, description.frame);
  for (const double x : description.lattice.origin) out.write(x);
  out.write(static_cast<std::int8_t>(description.lattice.step_exponent));
  out.write_varint(description.cell_steps);
  for (const std::int32_t x : description.cell_origin) out.write_varint(zigzag(x));
  out.write(static_cast<std::uint8_t>(description.grid ? 1 : 0));
  if (description.grid)
    for (const auto* numbers : {&description.grid->origin, &description.grid->edge})
      for (const double x : *numbers) out.write(x);
  out.write(static_cast<std::uint8_t>(description.attributes.size()));
  for (const MapAttribute& attribute : description.attributes)
    write_descriptor(out, descriptor_of(attribute));
  out.write(static_cast<std::uint8_t>(description.primers.size()));
  for (const MapPrimer& primer : description.primers) {
    for (const auto* bytes : {&primer.stream, &primer.border}) {
      out.write_varint(bytes->size());
      out.write_bytes(*bytes);
    }
  }
  return end_message(std::move(out));
}

Result<std::optional<VoxelGrid>> read_grid(ByteReader& in) {
  DELTAMESH_TRY(const auto grids, in.read<std::uint8_t>());
  if (grids > 1) return in.error(ErrorCode::kInvalidStream, "a map of more than one grid", "MAP-5");
  if (grids == 0) return std::optional<VoxelGrid>();
  VoxelGrid grid;
  for (auto* numbers : {&grid.origin, &grid.edge})
    for (double& x : *numbers) {
      DELTAMESH_TRY(x, in.read<double>());
    }
  return std::optional(grid);
}

Result<MapDescription> read_body(ByteReader in) {
  MapDescription description;
  DELTAMESH_TRY(description.id, in.read<std::uint64_t>());
  DELTAMESH_TRY(description.epoch, in.read<std::uint32_t>());
  DELTAMESH_TRY(description.frame, read_text(in));
  for (double& x : description.lattice.origin) {
    DELTAMESH_TRY(x, in.read<double>());
  }
  DELTAMESH_TRY(description.lattice.step_exponent, in.read<std::int8_t>());
  DELTAMESH_TRY(const auto cell_steps, in.read_varint(kMostCellSteps));
  description.cell_steps = static_cast<std::uint32_t>(cell_steps);
  for (std::int32_t& x : description.cell_origin) {
    DELTAMESH_TRY(const auto code, in.read_varint(std::numeric_limits<std::uint32_t>::max()));
    x = unzigzag(static_cast<std::uint32_t>(code));
  }
  DELTAMESH_TRY(description.grid, read_grid(in));
  DELTAMESH_TRY(const auto attributes, in.read<std::uint8_t>());
  for (unsigned i = 0; i < attributes; ++i) {
    DELTAMESH_TRY(auto attribute, read_attribute(in));
    description.attributes.push_back(std::move(attribute));
  }
  DELTAMESH_TRY(const auto primers, in.read<std::uint8_t>());
  for (unsigned i = 0; i < primers; ++i) {
    MapPrimer& primer = description.primers.emplace_back();
    for (auto* bytes : {&primer.stream, &primer.border}) {
      DELTAMESH_TRY(const auto size, in.read_varint());
      DELTAMESH_TRY(const auto read, in.read_bytes(size));
      bytes->assign(read.begin(), read.end());
    }
  }
  DELTAMESH_CHECK(in.finish());
  if (auto valid = validate(description); !valid) {
    Error error = valid.error();
    error.code = ErrorCode::kInvalidStream;
    return error;
  }
  return description;
}

}  // namespace

Result<std::vector<std::byte>> write_description(const MapDescription& description) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_CHECK(validate(description));
    return message_of(description);
  });
}

Result<MapDescription> read_description(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<MapDescription> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kMap));
    return read_body(ByteReader(body));
  });
}

std::uint64_t hash_of(const MapDescription& description) {
  const auto message = message_of(description);
  return XXH3_64bits(message.data(), message.size());
}

}  // namespace deltamesh
