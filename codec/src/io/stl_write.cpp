// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Binary STL.
#include <array>
#include <limits>
#include <string_view>

#include "base/byte_writer.h"
#include "base/numbers/vec3.h"
#include "io/formats.h"
#include "io/vertex_text.h"

namespace deltamesh {
namespace {

/// Unit normal by the right-hand rule; zero for a degenerate triangle.
Vec3 face_normal(const std::array<Vec3, 3>& corners) noexcept {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = length(normal);
  return size > 0 && size <= std::numeric_limits<double>::max() ? (1 / size) * normal : Vec3{};
}

}  // namespace

Result<std::vector<std::byte>> write_stl(const MeshView& mesh) {
  if (mesh.triangle_count() > std::numeric_limits<std::uint32_t>::max())
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more triangles than an STL file can hold"};
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
