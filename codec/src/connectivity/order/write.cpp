// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "base/numbers/zigzag.h"
#include "connectivity/order/coder.h"
#include "connectivity/order/order.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

/// Differences to the place that follows the one before, so that runs in order are runs of zeros [ORDR-1].
void write_permutation(ByteWriter& out, std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> symbols;
  symbols.reserve(places.size());
  std::uint32_t expected = 0;
  for (const std::uint32_t place : places) {
    symbols.push_back(zigzag(static_cast<std::int32_t>(place - expected)));
    expected = place + 1;
  }
  write_planes(out, symbols);
}

std::vector<std::byte> write_plain(const MeshOrder& order) {
  ByteWriter out;
  write_permutation(out, order.vertices);
  write_permutation(out, order.faces);
  write_planes(out, std::vector<std::uint32_t>(order.rotation.begin(), order.rotation.end()));
  return out.take();
}

}  // namespace

CodedOrder write_order(MeshOrder order, std::span<const std::uint32_t> triangles) {
  CodedOrder coded;
  coded.payload = write_plain(order);
  CompactWriter writer;
  OrderCoder<CompactWriter>(writer, triangles, static_cast<std::uint32_t>(order.vertices.size())).code(order);
  coded.compact = writer.finish();
  return coded;
}

}  // namespace deltamesh
