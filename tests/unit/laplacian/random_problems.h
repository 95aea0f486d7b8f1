// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Least-squares problems that are hard to settle: chains of fans, hubs, strips, tubes, sheets that hang by an
// edge, many small pieces; anchors few or many, spread out or in one place.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/graph_mesh.h"
#include "support/random.h"
#include "unit/laplacian/solver_problem.h"

namespace deltamesh::test {

/// What a seed makes, the same everywhere.
class RandomProblems {
 public:
  /// `vertices`: about so many, or a few times as many.
  RandomProblems(std::uint32_t seed, std::uint32_t vertices) : random_(seed), vertices_(vertices) {}

  SolverProblem make() {
    GraphMesh mesh;
    const std::uint32_t kinds = 1 + below(3);
    for (std::uint32_t kind = 0; kind < kinds; ++kind) add_kind(mesh, vertices_ / kinds);
    for (Vec3& position : mesh.positions) position = position + roughness_ * noise();
    const auto all = static_cast<std::uint32_t>(mesh.positions.size());
    const std::uint32_t counts[] = {1, 1 + below(8), 1 + all / 200, 1 + all / 40, 1 + all / 8};
    SolverProblem problem =
        quantized(finish(std::move(mesh)), counts[below(5)], 4 + static_cast<int>(below(9)));
    if (below(4) == 0) gather_anchors(problem);
    return problem;
  }

 private:
  std::uint32_t below(std::uint32_t bound) { return random_() % bound; }
  double fraction() { return std::ldexp(1.0 * (random_() % 65536), -16); }
  Vec3 noise() { return {fraction() - 0.5, fraction() - 0.5, fraction() - 0.5}; }

  /// Of about so many vertices, somewhere.
  void add_kind(GraphMesh& mesh, std::uint32_t vertices) {
    const Vec3 corner = 1000.0 * noise();
    const std::uint32_t side = 2 + below(30);
    const auto square = static_cast<std::uint32_t>(std::sqrt(vertices));
    switch (below(8)) {
      case 0:
        return add_sheet(mesh, square, square, corner);
      case 1:
        return add_sheet(mesh, std::max(vertices / side, 4U), side, corner);
      case 2:
        return add_sheet(mesh, vertices / (2 + side / 15), 2 + side / 15, corner);
      case 3:
        return add_tube(mesh, std::max(vertices / (side + 3), 2U), side + 3, corner);
      case 4:
        return add_fans(mesh, vertices, corner);
      case 5:
        return add_pieces(mesh, vertices, corner);
      case 6:
        return add_dumbbell(mesh, square, corner);
      default:
        return add_hub(mesh, std::min(vertices, 600 + 40 * side), corner);
    }
  }

  /// A sheet that is closed to a ring.
  static void add_tube(GraphMesh& mesh, std::uint32_t rings, std::uint32_t around, const Vec3& corner) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t y = 0; y < rings; ++y) {
      for (std::uint32_t x = 0; x < around; ++x) {
        const double angle = 6.283185307179586 * x / around;
        mesh.positions.push_back(corner + Vec3{around * std::cos(angle), around * std::sin(angle), 1.0 * y});
        if (y == 0) continue;
        const std::uint32_t row = first + y * around;
        const std::uint32_t next = (x + 1) % around;
        mesh.triangles.insert(mesh.triangles.end(), {row + x, row + next, row + x - around, row + next,
                                                     row + next - around, row + x - around});
      }
    }
  }

  /// Hubs in a row, each with the next one on its rim.
  void add_fans(GraphMesh& mesh, std::uint32_t vertices, const Vec3& corner) {
    auto hub = static_cast<std::uint32_t>(mesh.positions.size());
    Vec3 place = corner;
    mesh.positions.push_back(place);
    for (std::uint32_t made = 1; made < vertices;) {
      const std::uint32_t rim = 3 + below(5) * below(60);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (std::uint32_t i = 0; i < rim; ++i) {
        const double angle = 6.283185307179586 * i / rim;
        mesh.positions.push_back(place + Vec3{std::cos(angle), std::sin(angle), fraction()});
        mesh.triangles.insert(mesh.triangles.end(), {hub, first + i, first + (i + 1) % rim});
      }
      made += rim;
      hub = first;
      place = mesh.positions[hub];
    }
  }

  void add_pieces(GraphMesh& mesh, std::uint32_t vertices, const Vec3& corner) {
    for (std::uint32_t made = 0; made < vertices;) {
      const std::uint32_t width = 3 + below(8);
      const std::uint32_t height = 3 + below(1 + below(12));
      add_sheet(mesh, width, height, corner + 300.0 * noise());
      made += width * height;
    }
  }

  /// Two sheets and a strip, which hangs by one vertex of each.
  static void add_dumbbell(GraphMesh& mesh, std::uint32_t side, const Vec3& corner) {
    const std::uint32_t half = std::max(side * 7 / 10, 2U);
    add_sheet(mesh, half, half, corner);
    const auto strip = static_cast<std::uint32_t>(mesh.positions.size());
    add_sheet(mesh, side + 2, 2, corner + Vec3{1.0 * half, 1.0 * half, 0});
    const auto second = static_cast<std::uint32_t>(mesh.positions.size());
    add_sheet(mesh, half, half, corner + Vec3{1.0 * half + side, 1.0 * half, 0});
    mesh.triangles.insert(mesh.triangles.end(),
                          {strip - 1, strip, strip + 1, second, strip + side, strip + side + 1});
  }

  void add_hub(GraphMesh& mesh, std::uint32_t rim, const Vec3& corner) {
    const auto hub = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(corner);
    for (std::uint32_t i = 0; i < rim; ++i) {
      const double angle = 6.283185307179586 * i / rim;
      mesh.positions.push_back(corner + Vec3{10 * std::cos(angle), 10 * std::sin(angle), fraction()});
      if (i % 2 == 0 || below(5) > 0)
        mesh.triangles.insert(mesh.triangles.end(), {hub, hub + 1 + i, hub + 1 + (i + 1) % rim});
    }
  }

  /// As many vertices in a row as there were anchors, beside one for each component.
  void gather_anchors(SolverProblem& problem) {
    const GraphMesh& m = problem.mesh;
    std::vector<std::uint32_t> anchors = anchors_of(m, 1);
    const auto count = static_cast<std::uint32_t>(problem.anchors.size());
    const auto all = static_cast<std::uint32_t>(m.positions.size());
    const std::uint32_t begin = below(all - std::min(count, all - 1));
    for (std::uint32_t v = begin; v < std::min(begin + count, all); ++v) anchors.push_back(v);
    std::sort(anchors.begin(), anchors.end());
    anchors.erase(std::unique(anchors.begin(), anchors.end()), anchors.end());
    problem.targets.clear();
    for (const std::uint32_t anchor : anchors)
      problem.targets.push_back(round_to(m.positions[anchor], m.box.longest_side() / 4095));
    problem.anchors = std::move(anchors);
  }

  RandomBits random_;
  std::uint32_t vertices_;
  double roughness_ = 0.2;
};

}  // namespace deltamesh::test
