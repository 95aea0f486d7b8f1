// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Binary STL.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "base/byte_writer.h"
#include "base/numbers/vec3.h"
#include "io/formats.h"
#include "io/text/vertices.h"

namespace deltamesh {
namespace {

/// Unit normal by the right-hand rule; zero for a degenerate triangle.
Vec3 face_normal(const std::array<Vec3, 3>& corners) noexcept {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = length(normal);
  return size > 0 && size <= std::numeric_limits<double>::max() ? (1 / size) * normal : Vec3{};
}

void report_losses(const MeshView& mesh, WriteReport& report) {
  for (const AttributeView& attribute : mesh.attributes)
    report.leave_out(LeftOutKind::kVertexValues, attribute.name, mesh.vertex_count());
  leave_out_groups(mesh, report);
  std::vector<bool> used(mesh.vertex_count());
  for (const std::uint32_t v : mesh.triangles) used[v] = true;
  std::uint64_t rounded = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    const auto is_rounded = [&](std::size_t k) {
      const double exact = world_coordinate(mesh, v, k);
      return std::isfinite(exact) && static_cast<double>(to_float(exact)) != exact;
    };
    if (used[v] && (is_rounded(0) || is_rounded(1) || is_rounded(2))) ++rounded;
  }
  report.leave_out(LeftOutKind::kElements, "vertices that no face uses",
                   static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false)));
  report.leave_out(LeftOutKind::kPrecision, "positions", rounded);
}

}  // namespace

std::vector<std::byte> write_stl(const MeshView& mesh, WriteReport& report) {
  report_losses(mesh, report);
  // Readers take a header that begins with "solid" for text.
  constexpr std::string_view kTitle = "binary STL written by deltamesh";
  std::array<char, 80> header{};
  kTitle.copy(header.data(), header.size());
  ByteWriter out;
  out.write_bytes(std::as_bytes(std::span(header)));
  out.write(static_cast<std::uint32_t>(mesh.triangle_count()));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    std::array<Vec3, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        corners[c][k] = world_coordinate(mesh, mesh.triangles[3 * t + c], k);
    for (const double value : face_normal(corners)) out.write(to_float(value));
    for (const Vec3& corner : corners)
      for (const double value : corner) out.write(to_float(value));
    out.write(std::uint16_t{0});
  }
  return out.take();
}

}  // namespace deltamesh
