// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Texture coordinates from anywhere, over a surface whose faces, copies and positions come from the first
// bytes. What is read must be whole and finite, and must come back within the bound when written.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "attributes/uvs/uvs.h"
#include "goal.h"
#include "support/fuzzed_surface.h"

namespace {

using namespace deltamesh;

fuzz::Goal uvs_read("texture coordinates");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::FuzzedSurface fuzzed(std::as_bytes(std::span(data, size)));
  const AttributeSurface surface = fuzzed.surface();
  const auto read = read_surface_uvs(fuzzed.rest(), surface);
  if (!fuzz::check(read)) return 0;
  if (read->size() != std::size_t{2} * surface.vertex_count()) std::abort();
  double most = 0;
  for (const float x : *read) {
    if (!std::isfinite(x)) std::abort();
    most = std::fmax(most, std::fabs(static_cast<double>(x)));
  }
  const double bound = most > 0 ? most / 1000 : 1;
  const auto written = write_surface_uvs(*read, bound, surface);
  if (!written) {
    if (most > 0x1p-60 && most < 0x1p60) std::abort();
    return 0;
  }
  const auto again = read_surface_uvs(written->bytes, surface);
  if (!again || *again != written->values) std::abort();
  for (std::size_t i = 0; i < read->size(); i += 2) {
    const double u = static_cast<double>((*again)[i]) - static_cast<double>((*read)[i]);
    const double v = static_cast<double>((*again)[i + 1]) - static_cast<double>((*read)[i + 1]);
    if (!(std::sqrt(u * u + v * v) <= bound)) std::abort();
  }
  uvs_read.reach();
  return 0;
}
