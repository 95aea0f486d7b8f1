// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_positions on arbitrary payloads over a small mesh. The last six bytes choose mesh, lattice, form and
// levels.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "positions/positions.h"
#include "support/graph_mesh.h"

namespace {

using namespace deltamesh;

test::GraphMesh choose_mesh(unsigned choice) {
  switch (choice % 4) {
    case 0:
      return test::fragments();
    case 1:
      return test::sheet(6, 5);
    case 2:
      return test::fan(40);
    default:
      return test::finish({});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 6) return 0;
  const std::uint8_t* choice = data + size - 6;
  const auto bytes = std::as_bytes(std::span(data, size - 6));
  const test::GraphMesh mesh = choose_mesh(choice[0]);
  const auto cells = static_cast<std::uint32_t>((std::uint64_t{1} << (choice[1] % 29)) - choice[1] / 128);
  // Any number of levels, of any size.
  const std::uint32_t raw = choice[3] + 256U * choice[4] + 65536U * choice[5];
  const std::uint32_t levels = 1 + ((raw % kMostLevels) >> (choice[2] / 8 % 20));
  const PredictiveParameters parameters{.kind = static_cast<PositionKind>(choice[0] / 64 % 3),
                                        .lattice = {.cells = {cells, cells, cells}},
                                        .levels = levels};
  const FaceList faces{mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
  const Payload payload = choice[2] % 8 == 0 ? Payload(bytes) : Payload::compact(bytes);
  const auto positions = read_positions(payload, faces, parameters, mesh.box);
  if (!positions) {
    if (positions.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (positions->size() != 3 * mesh.positions.size()) std::abort();
  for (const float x : *positions)
    if (!std::isfinite(x)) std::abort();
  return 0;
}
