// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact coder alone, and the compact forms of CONN, DELT, ANCH and ATTR, on bytes from anywhere. The
// first byte chooses which; what a reader accepts is written and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "coder_run.h"
#include "connectivity/faces/faces.h"
#include "goal.h"
#include "highpass/compact.h"
#include "support/graph_mesh.h"

namespace {

using namespace deltamesh;

fuzz::Goal coder_read("the coder's symbols");
fuzz::Goal connectivity_read("CONN");
fuzz::Goal deltas_read("DELT");
fuzz::Goal anchors_read("ANCH");
fuzz::Goal attribute_read("ATTR");

void require(bool condition) {
  if (!condition) std::abort();
}

/// Symbols of every kind, as many as the bytes last for; then the same symbols through a writer.
void fuzz_coder(std::span<const std::byte> bytes) {
  std::vector<std::uint32_t> values;
  CompactReader reader(bytes);
  fuzz::run_coder(reader, values, [&](std::size_t i) { return i < fuzz::kMostRun && !reader.failed(); });
  const auto finished = reader.finish(0);
  fuzz::check(finished);
  CompactWriter writer;
  std::vector<std::uint32_t> copy = values;
  fuzz::run_coder(writer, copy, [&](std::size_t i) { return i < values.size(); });
  const auto written = writer.finish();
  CompactReader again(written);
  std::vector<std::uint32_t> back;
  fuzz::run_coder(again, back, [&](std::size_t i) { return i < values.size(); });
  require(back == values && again.finish(0).has_value());
  if (finished) coder_read.reach();
}

void fuzz_connectivity(std::span<const std::byte> bytes, std::uint32_t faces) {
  constexpr std::uint32_t kVertices = 60;
  const auto read = read_connectivity(bytes, kVertices, faces);
  if (!fuzz::check(read)) return;
  require(read->triangles.size() == std::size_t{3} * faces);
  for (const std::uint32_t v : read->triangles) require(v < kVertices);
  const Adjacency graph = build_adjacency(read->triangles, kVertices);
  const Adjacency quick = build_adjacency(read->triangles, read->open_edges, kVertices);
  require(quick.offsets == graph.offsets && quick.neighbors == graph.neighbors);
  require(read->runs.components(kVertices).label == find_components(graph).label);
  const auto coded = write_connectivity(read->triangles, kVertices);
  const auto again = read_connectivity(coded.payload, kVertices, faces);
  require(faces == 0 || (again && again->triangles == coded.triangles));
  connectivity_read.reach();
}

void fuzz_deltas(std::span<const std::byte> bytes) {
  static const test::GraphMesh kMesh = test::sheet(6, 5);
  const auto read = read_compact_deltas(bytes, kMesh.graph);
  if (!fuzz::check(read)) return;
  const auto again = read_compact_deltas(write_compact_deltas(*read, kMesh.graph), kMesh.graph);
  require(again && *again == *read);
  deltas_read.reach();
}

void fuzz_anchors(std::span<const std::byte> bytes, std::uint32_t count) {
  const auto read = read_anchors(bytes, count);
  if (!fuzz::check(read)) return;
  const auto again = read_anchors(write_compact_anchors(*read), count);
  require(again && again->gaps == read->gaps && again->steps == read->steps);
  anchors_read.reach();
}

void fuzz_attribute(std::span<const std::byte> bytes) {
  static const test::GraphMesh kMesh = test::sheet(6, 5);
  if (bytes.size() < 3) return;
  const auto rows = static_cast<std::uint32_t>(kMesh.graph.vertex_count());
  const AttributeSurface surface(kMesh.triangles, rows);
  const auto number = [&](std::size_t i, unsigned range) {
    return static_cast<std::uint8_t>(static_cast<unsigned>(bytes[i]) % range);
  };
  const AttributeDescriptor descriptor{
      .kind = static_cast<AttributeKind>(number(0, kAttributeKinds)),
      .type = static_cast<ComponentType>(number(1, 8)),
      .components = static_cast<std::uint8_t>(1 + number(2, kMaxComponents))};
  const auto read = read_attribute(Payload::compact(bytes.subspan(3)), descriptor, surface, {}, 1 << 16);
  if (!fuzz::check(read)) return;
  require(read->values.size() == attribute_bytes(descriptor, rows));
  attribute_read.reach();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const unsigned choice = data[0] % 5;
  const std::uint32_t count = data[1];
  const auto bytes = std::as_bytes(std::span(data, size)).subspan(2);
  if (choice == 0) fuzz_coder(bytes);
  if (choice == 1) fuzz_connectivity(bytes, count);
  if (choice == 2) fuzz_deltas(bytes);
  if (choice == 3) fuzz_anchors(bytes, count);
  if (choice == 4) fuzz_attribute(bytes);
  return 0;
}
