// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map/map_peers.h"

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/lattice.h"
#include "support/or_exit.h"
#include "support/processor_seconds.h"

namespace deltamesh::bench {
namespace {

void add_values(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data_type,
                std::size_t size, std::span<const std::byte> values) {
  draco::GeometryAttribute layout;
  layout.Init(type, nullptr, 3, data_type, data_type == draco::DT_UINT8, static_cast<std::int64_t>(size), 0);
  draco::PointAttribute& attribute = *mesh.attribute(mesh.AddAttribute(layout, true, mesh.num_points()));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
    attribute.SetAttributeValue(draco::AttributeValueIndex(i), values.data() + i * size);
}

/// The fewest bits whose rounding moves no vertex by more.
int bits_for(const Mesh& block, double max_error) {
  int bits = 2;
  while (bits < 24 && std::sqrt(3.0) / 2 * make_lattice(block, bits).cell > max_error) ++bits;
  return bits;
}

std::vector<std::byte> stepped(const Attribute& color, int color_error) {
  std::vector<std::byte> values = color.values;
  for (std::byte& value : values)
    value = static_cast<std::byte>((std::to_integer<int>(value) + color_error) / (2 * color_error + 1));
  return values;
}

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::exit(EXIT_FAILURE);
}

}  // namespace

std::size_t raw_bytes(const Mesh& block) {
  const std::size_t color = block.attributes.empty() ? 0 : 16;
  return (12 + color) * block.vertex_count() + 12 * block.triangle_count() + 12 + 12;
}

CodedBlock draco_block(const Mesh& block, double max_error, int color_error) {
  CodedBlock coded;
  double start = processor_seconds();
  draco::Mesh input;
  input.set_num_points(static_cast<std::uint32_t>(block.vertex_count()));
  input.SetNumFaces(block.triangle_count());
  for (std::uint32_t f = 0; f < block.triangle_count(); ++f) {
    const std::uint32_t* corners = block.triangles.data() + std::size_t{3} * f;
    input.SetFace(draco::FaceIndex(f), {draco::PointIndex(corners[0]), draco::PointIndex(corners[1]),
                                        draco::PointIndex(corners[2])});
  }
  add_values(input, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 12,
             std::as_bytes(std::span(block.positions)));
  if (!block.attributes.empty())
    add_values(input, draco::GeometryAttribute::COLOR, draco::DT_UINT8, 3,
               stepped(block.attributes.front(), color_error));
  draco::Encoder encoder;
  encoder.SetSpeedOptions(0, 0);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits_for(block, max_error));
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(input, &buffer).ok()) fail("Draco cannot encode a block");
  coded.bytes = buffer.size();
  coded.encode_seconds = processor_seconds() - start;
  start = processor_seconds();
  draco::DecoderBuffer stream;
  stream.Init(buffer.data(), buffer.size());
  if (!draco::Decoder().DecodeMeshFromBuffer(&stream).ok()) fail("Draco cannot decode a block");
  coded.decode_seconds = processor_seconds() - start;
  return coded;
}

CodedBlock plain_block(const Mesh& block, double max_error, int color_error, int effort) {
  EncodeOptions options;
  options.quality.max_error = QualityBound{max_error};
  options.attributes.color_error = color_error;
  options.effort = effort;
  CodedBlock coded;
  double start = processor_seconds();
  const Encoded encoded = value_or_exit(encode(block, options));
  coded.bytes = encoded.bytes.size();
  coded.encode_seconds = processor_seconds() - start;
  start = processor_seconds();
  check_or_exit(decode(encoded.bytes));
  coded.decode_seconds = processor_seconds() - start;
  return coded;
}

}  // namespace deltamesh::bench
