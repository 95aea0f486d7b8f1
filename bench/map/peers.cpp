// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map/peers.h"

#include <cmath>
#include <span>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/draco_mesh.h"
#include "peers/lattice.h"
#include "support/errors.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

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

/// Processor times and bytes of `encode`, which returns a stream, and `decode` of that.
template <class Encode, class Decode>
CodedBlock time_block(Encode encode, Decode decode) {
  CodedBlock coded;
  const double start = processor_seconds();
  const std::vector<std::byte> stream = encode();
  coded.bytes = stream.size();
  const double middle = processor_seconds();
  coded.encode_seconds = middle - start;
  check_or_exit(decode(stream));
  coded.decode_seconds = processor_seconds() - middle;
  return coded;
}

}  // namespace

std::size_t raw_bytes(const Mesh& block) {
  const std::size_t color = block.attributes.empty() ? 0 : 16;
  return (12 + color) * block.vertex_count() + 12 * block.triangle_count() + 12 + 12;
}

CodedBlock draco_block(const Mesh& block, const Bounds& bounds) {
  const auto encode = [&] {
    MeshView view(block);
    std::vector<std::byte> colors;
    if (!view.attributes.empty()) {
      colors = stepped(block.attributes.front(), bounds.color_error);
      view.attributes.resize(1);
      view.attributes.front().values = colors;
    }
    const DracoSetting setting{.position_bits = bits_for(block, bounds.max_error)};
    return value_or_exit(encode_draco(*to_draco(view), setting, 10));
  };
  return time_block(encode, decode_draco);
}

CodedBlock plain_block(const Mesh& block, const Bounds& bounds) {
  EncodeOptions options;
  options.quality.max_error = QualityBound{bounds.max_error};
  options.attributes = quality_of(bounds);
  options.effort = bounds.effort;
  return time_block([&] { return value_or_exit(encode(block, options)).bytes; },
                    [](std::span<const std::byte> stream) { return decode(stream); });
}

}  // namespace deltamesh::bench
