// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Seeds of positions: predicted, by highpass coding, and on grids.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "grid/grid.h"
#include "highpass/compact.h"
#include "highpass/highpass.h"
#include "positions/plain.h"
#include "positions/positions.h"
#include "seeds.h"
#include "targets/chunks/meshes.h"
#include "unit/grid/grid_meshes.h"

namespace deltamesh::fuzz {
namespace {

const std::array<std::string, 5> kMeshNames = {"fragments", "sheet", "fan", "point", "empty"};

/// With `step` 2^(4k - 512), as the target has it.
void make_highpass_of(const Corpora& corpora, unsigned choice, bool is_plain, int cycles) {
  constexpr int kAnchorBits = 12;
  constexpr unsigned kStep = 126;  // 2^-8
  const test::GraphMesh mesh = choose_mesh(choice);
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box, is_plain);
  const HighpassSettings settings{
      .step = std::ldexp(1.0, 4 * static_cast<int>(kStep) - 512), .anchors = 4, .anchor_bits = kAnchorBits};
  const CodedHighpass coded = check(coder.code(settings, cycles));
  corpora.add(
      "highpass", kMeshNames[choice] + (is_plain ? "_plain_" : "_compact_") + std::to_string(cycles),
      coded.deltas + coded.anchors +
          bytes_of({choice + 5 * static_cast<unsigned>(cycles), kAnchorBits + (is_plain ? 0U : 128U),
                    coded.parameters.anchors, kStep, coded.deltas.size() % 256, coded.deltas.size() / 256}));
}

void make_highpass(const Corpora& corpora) {
  for (unsigned choice = 0; choice < kMeshNames.size(); ++choice)
    for (const bool is_plain : {false, true}) make_highpass_of(corpora, choice, is_plain, 1);
  for (const int cycles : {3, 8}) make_highpass_of(corpora, 0, false, cycles);
}

/// DELT and ANCH alone, for the coder's target.
void make_symbols(const Corpora& corpora) {
  const test::GraphMesh mesh = test::sheet(6, 5);
  for (const std::int32_t scale : {3, 1 << 20}) {
    std::vector<std::int32_t> deltas;
    for (std::int32_t i = 0; i < 90; ++i) deltas.push_back((i * 7 % 11 - 5) * scale / 4);
    const Bytes seed = bytes_of({2, 0}) + write_compact_deltas(deltas, mesh.graph);
    corpora.add("compact", scale == 3 ? "deltas" : "deltas_large", seed);
    if (scale != 3) corpora.add("compact", "deltas_cut", std::span(seed).first(seed.size() / 2));
  }
  AnchorList list;
  for (std::uint32_t i = 0; i < 20; ++i) list.gaps.push_back(i * i % 13);
  for (std::uint32_t i = 0; i < 60; ++i) list.steps.push_back(i * i * i % 5000);
  corpora.add("compact", "anchors", bytes_of({3, 20}) + write_compact_anchors(list));
}

/// On a lattice of 2^bits cells whose middle is the mesh's.
std::vector<Cell> cells_of(const test::GraphMesh& mesh, unsigned bits) {
  std::vector<Cell> cells;
  for (const Vec3& p : mesh.positions)
    for (Cell& cell = cells.emplace_back(); const std::size_t axis : {0U, 1U, 2U}) {
      const double side = std::max(mesh.box.longest_side(), 1.0);
      cell[axis] = static_cast<std::int32_t>(std::ldexp((p[axis] - mesh.box.min[axis]) / side, bits));
    }
  return cells;
}

void make_predictive(const Corpora& corpora) {
  constexpr unsigned kBits = 12;
  constexpr unsigned kCompact = 1;
  constexpr unsigned kPlain = 0;
  constexpr unsigned kFloats = 130;  // a multiple of 5, the number of meshes, at 128 or above
  const PredictiveParameters parameters{.lattice = {.cells = {1U << kBits, 1U << kBits, 1U << kBits}}};
  for (unsigned choice = 0; choice < kMeshNames.size(); ++choice) {
    const test::GraphMesh mesh = choose_mesh(choice);
    const FaceList faces{mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
    const std::vector<Cell> cells = cells_of(mesh, kBits);
    const auto add = [&](const std::string& name, unsigned kind, const Bytes& payload, unsigned form) {
      corpora.add("predictive", kMeshNames[choice] + name, payload + bytes_of({choice + kind, kBits, form}));
    };
    add("_guesses", 0, write_positions(faces, cells, parameters, {.guesses = Guessing::kAlways}), kCompact);
    add("_broad", 0, write_positions(faces, cells, parameters, {.coding_order = CodingOrder::kBroad}),
        kCompact);
    add("_deep", 0, write_positions(faces, cells, parameters, {.coding_order = CodingOrder::kDeep}),
        kCompact);
    if (faces.vertex_count > 1)
      add("_replaced", 0,
          write_positions(faces, cells, parameters, {}, std::vector<Replacement>{{1, 0.1F}, {4, -3e20F}}),
          kCompact);
    add("_plain", 0, write_plain_cells(cells), kPlain);
    std::vector<Vec3> floats;
    for (const Vec3& p : mesh.positions)
      floats.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    if (!floats.empty())
      add("_floats", kFloats, write_floats(faces, floats, mesh.box, {.guesses = Guessing::kAlways}),
          kCompact);
    add("_plain_floats", kFloats, write_plain_floats(floats), kPlain);
  }
}

void add_grid(const Corpora& corpora, const std::string& name, const test::CellMesh& mesh) {
  const CodedGrid coded = check(write_grid(mesh.triangles, mesh.cells, mesh.parameters));
  const std::size_t faces = mesh.triangles.size() / 3;
  const std::size_t rest = coded.payloads.rest_faces.size();
  const std::uint32_t spans = mesh.parameters.lattice.cells[0] / (2 * mesh.parameters.levels);
  corpora.add("grid", name,
              coded.payloads.surface + coded.payloads.rest_faces +
                  bytes_of({mesh.cells.size() % 256, mesh.cells.size() / 256, faces % 256, faces / 256,
                            rest % 256, rest / 256, mesh.parameters.levels - 1, spans, spans}));
}

void make_grid(const Corpora& corpora) {
  for (const std::uint32_t levels : {1U, 16U, 256U}) {
    const auto ball = [](int i, int j, int k) {
      return std::hypot(static_cast<float>(i - 5), static_cast<float>(j - 5), static_cast<float>(k - 5)) -
             3.3F;
    };
    test::CellMesh mesh = test::surface_of(ball, 12, levels);
    add_grid(corpora, "ball_" + std::to_string(levels), mesh);
    // Faces from one vertex to two far from it.
    const auto count = static_cast<std::uint32_t>(mesh.cells.size());
    for (std::uint32_t v = 0; v < 6; ++v)
      mesh.triangles.insert(mesh.triangles.end(), {v, v + count / 3, v + count / 2});
    add_grid(corpora, "rest_" + std::to_string(levels), mesh);
  }
  add_grid(corpora, "waves", test::wavy_surface(16, 9));
  add_grid(corpora, "new_patterns", test::random_faces(1, 7, 4, 80));
}

}  // namespace

void make_geometry(const Corpora& corpora) {
  make_highpass(corpora);
  make_symbols(corpora);
  make_predictive(corpora);
  make_grid(corpora);
}

}  // namespace deltamesh::fuzz
