// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tangents from anywhere, over a surface whose faces, copies, positions, normals and texture coordinates come
// from the first bytes. What is read must be whole unit vectors, and must come back within the bound when
// written.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "attributes/tangents/tangents.h"
#include "base/numbers/portable_math.h"
#include "goal.h"
#include "meshes.h"

namespace {

using namespace deltamesh;

fuzz::Goal tangents_read("tangents");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzedSurface fuzzed(std::as_bytes(std::span(data, size)));
  const AttributeSurface surface = fuzzed.surface();
  const TangentBasis basis = fuzz::basis_of(fuzzed);
  const auto read = read_surface_tangents(fuzzed.rest(), surface, basis);
  if (!fuzz::check(read)) return 0;
  if (read->size() != std::size_t{4} * surface.vertex_count()) std::abort();
  const double bound = 0.5;
  const auto written = write_surface_tangents(*read, bound, surface, basis);
  if (!written) std::abort();
  const auto again = read_surface_tangents(written->bytes, surface, basis);
  if (!again || *again != written->values) std::abort();
  const auto vector_of = [](const std::vector<float>& t, std::size_t i) {
    return Vec3{static_cast<double>(t[i]), static_cast<double>(t[i + 1]), static_cast<double>(t[i + 2])};
  };
  for (std::size_t i = 0; i < read->size(); i += 4) {
    if (!(portable_degrees_between(vector_of(*read, i), vector_of(*again, i)) <= bound)) std::abort();
    if ((*read)[i + 3] != (*again)[i + 3] || std::fabs((*read)[i + 3]) != 1) std::abort();
  }
  tangents_read.reach();
  return 0;
}
