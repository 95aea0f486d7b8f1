// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "peers/meshopt_streams.h"

#include <meshoptimizer.h>

namespace deltamesh::bench {
namespace {

unsigned char* chars(std::vector<std::byte>& raw, std::size_t first) {
  return reinterpret_cast<unsigned char*>(raw.data()) + first;
}

}  // namespace

MeshoptOrder meshopt_order(std::span<const std::uint32_t> triangles, std::size_t vertices) {
  MeshoptOrder order{.indices = std::vector<std::uint32_t>(triangles.size()),
                     .place = std::vector<std::uint32_t>(vertices)};
  meshopt_optimizeVertexCacheStrip(order.indices.data(), triangles.data(), triangles.size(), vertices);
  meshopt_optimizeVertexFetchRemap(order.place.data(), order.indices.data(), triangles.size(), vertices);
  for (std::uint32_t& index : order.indices) index = order.place[index];
  return order;
}

std::size_t append_vertices(std::vector<std::byte>& raw, std::span<const std::byte> rows, std::size_t size,
                            const MeshoptOrder& order) {
  const std::size_t n = order.place.size();
  std::vector<std::byte> ordered(rows.size());
  meshopt_remapVertexBuffer(ordered.data(), rows.data(), n, size, order.place.data());
  const std::size_t first = raw.size();
  const std::size_t bound = meshopt_encodeVertexBufferBound(n, size);
  raw.resize(first + bound);
  const std::size_t bytes = meshopt_encodeVertexBuffer(chars(raw, first), bound, ordered.data(), n, size);
  raw.resize(first + bytes);
  return bytes;
}

void append_indices(std::vector<std::byte>& raw, const MeshoptOrder& order) {
  const std::size_t first = raw.size();
  const std::size_t bound = meshopt_encodeIndexBufferBound(order.indices.size(), order.place.size());
  raw.resize(first + bound);
  raw.resize(first +
             meshopt_encodeIndexBuffer(chars(raw, first), bound, order.indices.data(), order.indices.size()));
}

}  // namespace deltamesh::bench
