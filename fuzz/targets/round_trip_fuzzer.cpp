// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any small triangle soup through encode() and decode(): same faces, stated error. The first two bytes choose
// options and the number of vertices; then come coordinates, then indices, as long as bytes last.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "goal.h"

namespace {

deltamesh::fuzz::Goal came_back("a mesh");

deltamesh::Mesh mesh_of(const std::uint8_t* data, std::size_t size, std::size_t vertices) {
  deltamesh::Mesh mesh;
  const std::size_t coordinates = std::min(size, 3 * vertices) / 3 * 3;
  for (std::size_t i = 0; i < coordinates; ++i) mesh.positions.push_back(static_cast<float>(data[i]) / 8);
  const std::size_t count = mesh.vertex_count();
  for (std::size_t i = coordinates; count > 0 && i + 3 <= size; i += 3) {
    for (std::size_t c = 0; c < 3; ++c)
      mesh.triangles.push_back(static_cast<std::uint32_t>(data[i + c] % count));
  }
  return mesh;
}

/// Over the decoded vertices, whose input vertices are `order`.
double largest_error(const deltamesh::Mesh& mesh, const deltamesh::Mesh& decoded,
                     const std::vector<std::uint32_t>& order) {
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d =
          double{mesh.positions[3 * std::size_t{order[i]} + axis]} - decoded.positions[3 * i + axis];
      square += d * d;
    }
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  if (size < 2) return 0;
  const Mesh mesh = mesh_of(data + 2, size - 2, data[1]);
  const EncodeOptions options{.bits = 3 + data[0] % 14,
                              .keep_order = (data[0] & 0x80) != 0,
                              .keep_unreferenced = (data[0] & 0x40) != 0};
  const auto encoded = encode(mesh, options);
  if (!encoded) std::abort();
  const auto decoded = decode(encoded->bytes);
  if (!decoded || decoded->triangle_count() != mesh.triangle_count()) std::abort();
  const double stated = encoded->report.stream.quality.max_error * (1 + 1e-12);  // another order of rounding
  if (largest_error(mesh, *decoded, encoded->order) > stated) std::abort();
  std::vector<std::uint64_t> before;
  std::vector<std::uint64_t> after;
  const auto sums = [](std::span<const std::uint32_t> t, auto&& rename, std::vector<std::uint64_t>& out) {
    for (std::size_t i = 0; i < t.size(); i += 3) {
      std::uint64_t best = ~std::uint64_t{0};
      for (std::size_t turn = 0; turn < 3; ++turn) {
        std::uint64_t key = 0;
        for (std::size_t c = 0; c < 3; ++c) key = key << 16 | rename(t[i + (turn + c) % 3]);
        best = std::min(best, key);
      }
      out.push_back(best);
    }
    std::sort(out.begin(), out.end());
  };
  sums(
      mesh.triangles, [](std::uint32_t v) { return v; }, before);
  sums(
      decoded->triangles, [&](std::uint32_t v) { return encoded->order[v]; }, after);
  if (before != after) std::abort();
  came_back.reach();
  return 0;
}
