// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_positions on arbitrary payloads over a small mesh. The last three bytes choose mesh, lattice, kind
// and form.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "goal.h"
#include "meshes.h"
#include "positions/plain.h"
#include "positions/positions.h"

namespace {

using namespace deltamesh;

fuzz::Goal on_lattice("the compact form on a lattice");
fuzz::Goal floats("floats in the compact form");
fuzz::Goal plain_on_lattice("the plain form on a lattice");
fuzz::Goal plain_floats("floats in the plain form");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::uint8_t* choice = data + size - 3;
  const auto bytes = std::as_bytes(std::span(data, size - 3));
  const test::GraphMesh mesh = fuzz::choose_mesh(choice[0]);
  const auto cells = static_cast<std::uint32_t>((std::uint64_t{1} << (choice[1] % 29)) - choice[1] / 128);
  const PredictiveParameters parameters{
      .kind = choice[0] < 128 ? PositionKind::kLattice : PositionKind::kFloats,
      .lattice = {.cells = {cells, cells, cells}}};
  const FaceList faces{mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
  const bool is_plain = choice[2] % 8 == 0;
  const auto positions = is_plain ? read_plain_positions(bytes, faces.vertex_count, parameters)
                                  : read_positions(bytes, faces, parameters, mesh.box);
  if (!fuzz::check(positions)) return 0;
  if (positions->size() != 3 * mesh.positions.size()) std::abort();
  for (const float x : *positions)
    if (!std::isfinite(x)) std::abort();
  if (parameters.kind == PositionKind::kFloats) {
    (is_plain ? plain_floats : floats).reach();
  } else {
    (is_plain ? plain_on_lattice : on_lattice).reach();
  }
  return 0;
}
