// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Surface normals from anywhere, over a small mesh that the input chooses. Byte 0: bit 0 whether there are
// positions, bit 1 whether faces share vertices; then the number of faces, vertex numbers and positions of
// the mesh; the rest is the payload. What is read must be unit vectors or zero, and must come back within
// a bound when written.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "attributes/normals/normals.h"
#include "base/numbers/portable_math.h"
#include "base/numbers/vec3.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  if (size < 2) return 0;
  const std::uint8_t flags = data[0];
  const std::size_t corners = 3 * std::size_t{data[1]};
  if (size < 2 + corners) return 0;
  std::vector<std::uint32_t> triangles(data + 2, data + 2 + corners);
  const std::uint32_t geometric_count =
      triangles.empty() ? 1 : *std::max_element(triangles.begin(), triangles.end()) + 1;
  std::vector<std::uint32_t> geometric;
  if ((flags & 2) != 0) {
    // A copy for each corner, one at least, by geometric vertex.
    std::vector<std::uint32_t> copies(corners);
    for (std::uint32_t g = 0; g < geometric_count; ++g) {
      if (std::find(triangles.begin(), triangles.end(), g) == triangles.end()) geometric.push_back(g);
      for (std::size_t c = 0; c < corners; ++c) {
        if (triangles[c] != g) continue;
        copies[c] = static_cast<std::uint32_t>(geometric.size());
        geometric.push_back(g);
      }
    }
    triangles = copies;
  }
  const auto count = geometric.empty() ? geometric_count : static_cast<std::uint32_t>(geometric.size());
  std::vector<float> positions;
  for (std::uint32_t v = 0; v < 3 * count && (flags & 1) != 0; ++v) {
    const std::uint32_t g = geometric.empty() ? v / 3 : geometric[v / 3];
    positions.push_back(static_cast<float>((g * 37 + v % 3 * 11 + g * g % 7) % 64));
  }
  const AttributeSurface surface(triangles, count, geometric, positions);
  const auto read =
      read_surface_normals(std::as_bytes(std::span(data + 2 + corners, size - 2 - corners)), surface);
  if (!read) {
    if (read.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (read->size() != 3 * std::size_t{count}) std::abort();
  const auto at = [](const std::vector<float>& values, std::size_t v) {
    return Vec3{values[3 * v], values[3 * v + 1], values[3 * v + 2]};
  };
  for (std::uint32_t v = 0; v < count; ++v) {
    const double square = dot(at(*read, v), at(*read, v));
    if (square != 0 && !(std::fabs(square - 1) < 1e-5)) std::abort();
  }
  constexpr double kDegrees = 0.7;
  const auto written = write_surface_normals(*read, kDegrees, surface);
  if (!written) std::abort();
  const auto again = read_surface_normals(written->bytes, surface);
  if (!again || *again != written->values) std::abort();
  for (std::uint32_t v = 0; v < count; ++v)
    if (portable_degrees_between(at(*again, v), at(*read, v)) > kDegrees) std::abort();
  return 0;
}
