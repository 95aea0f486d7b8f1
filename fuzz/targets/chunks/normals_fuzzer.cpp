// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Surface normals from anywhere, over a small mesh that comes from the first bytes. What is read must be unit
// vectors or zero, and must come back within a bound when written.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "attributes/normals/normals.h"
#include "base/numbers/portable_math.h"
#include "base/numbers/vec3.h"
#include "goal.h"
#include "meshes.h"

namespace {

using namespace deltamesh;

fuzz::Goal normals_read("normals");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::FacesOfBytes faces(std::as_bytes(std::span(data, size)));
  const AttributeSurface surface = faces.surface();
  const std::uint32_t count = surface.vertex_count();
  const auto read = read_surface_normals(faces.rest(), surface);
  if (!fuzz::check(read)) return 0;
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
  normals_read.reach();
  return 0;
}
