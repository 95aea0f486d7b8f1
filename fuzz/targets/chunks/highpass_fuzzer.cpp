// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_highpass on arbitrary payloads over a small graph. The last six bytes choose graph and cycles,
// anchor bits (and 128 for the compact form), number of anchors, size of the step, and where the ANCH payload
// begins.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "goal.h"
#include "highpass/highpass.h"
#include "meshes.h"

namespace {

using namespace deltamesh;

fuzz::Goal plain_read("the plain form");
fuzz::Goal compact_read("the compact form");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 6) return 0;
  const std::uint8_t* choice = data + size - 6;
  const auto payload = std::as_bytes(std::span(data, size - 6));
  const test::GraphMesh mesh = fuzz::choose_mesh(choice[0]);
  const HighpassParameters parameters{.bits = 8,
                                      .step = std::ldexp(1.0, choice[3] * 4 - 512),
                                      .anchor_bits = static_cast<std::uint8_t>(choice[1] % 128 % 26),
                                      .anchors = choice[2] % 90U,
                                      .anchor_density = 1,
                                      .cycles = static_cast<std::uint8_t>(choice[0] / 5)};
  const std::size_t split = payload.empty() ? 0 : (choice[4] + 256U * choice[5]) % (payload.size() + 1);
  Payload deltas = payload.first(split);
  Payload anchors = payload.subspan(split);
  deltas.is_compact = anchors.is_compact = choice[1] >= 128;
  const auto positions = read_highpass(deltas, anchors, mesh.graph, mesh.components, mesh.box, parameters);
  if (!fuzz::check(positions)) return 0;
  if (positions->size() != mesh.positions.size()) std::abort();
  for (const Vec3& position : *positions) {
    if (!std::isfinite(position[0] + position[1] + position[2])) std::abort();
  }
  (deltas.is_compact ? compact_read : plain_read).reach();
  return 0;
}
