// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The two solvers of highpass streams side by side, as a Markdown table: time per vertex, what is left of the
// exact solution, and what that does to the low-frequency error.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "connectivity/connectivity.h"
#include "laplacian/anchors.h"
#include "laplacian/delta.h"
#include "laplacian/solved_part.h"
#include "laplacian/solver.h"
#include "support/welded_mesh.h"

namespace {

using namespace deltamesh;

/// Graph in coding order, and what the stream would say.
struct Problem {
  SolvedPart part;
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;
  std::vector<Vec3> targets;
};

struct Settings {
  std::string corpus;
  double anchor_percent = 0.5;
  int bits = 8;
  std::uint32_t largest = 1000000;
  std::uint32_t largest_direct = 300000;
};

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Vec3 round_to(const Vec3& v, double step) {
  return {step * std::round(v[0] / step), step * std::round(v[1] / step), step * std::round(v[2] / step)};
}

Problem make_problem(const std::vector<std::uint32_t>& triangles, const std::vector<Vec3>& positions,
                     const Settings& settings) {
  const auto vertex_count = static_cast<std::uint32_t>(positions.size());
  const CodedConnectivity coded = write_connectivity(triangles, vertex_count);
  const Adjacency graph = build_adjacency(coded.triangles, vertex_count);
  Problem problem{extract_solved_part(graph, find_components(graph)), {}, {}, {}, {}};
  for (const std::uint32_t vertex : problem.part.vertices)
    problem.positions.push_back(positions[coded.vertex_order[vertex]]);
  const Adjacency& solved = problem.part.graph;
  const auto count =
      static_cast<std::uint32_t>(0.01 * settings.anchor_percent * static_cast<double>(solved.vertex_count()));
  problem.anchors = place_anchors(solved, find_components(solved), {.count = count}).vertices;
  problem.deltas = delta_coordinates(solved, problem.positions);
  const double step = std::ldexp(delta_range(problem.deltas), -settings.bits);
  for (Vec3& delta : problem.deltas) delta = round_to(delta, step);
  for (const std::uint32_t anchor : problem.anchors) problem.targets.push_back(problem.positions[anchor]);
  return problem;
}

struct Solved {
  double setup_ns = 0;  ///< per vertex
  double solve_ns = 0;
  std::vector<Vec3> x;
};

template <class Make>
Solved run(const Problem& problem, const Make& make) {
  Solved solved;
  solved.x.resize(problem.positions.size());
  const double per_vertex = 1e9 / static_cast<double>(problem.positions.size());
  const double start = seconds();
  const auto solver = make(problem.part.graph, problem.anchors);
  const double made = seconds();
  if (solver && (*solver)->solve(problem.deltas, problem.targets, solved.x)) {
    solved.setup_ns = (made - start) * per_vertex;
    solved.solve_ns = (seconds() - made) * per_vertex;
  }
  return solved;
}

double rms_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, length(a[i] - b[i]));
  return largest;
}

void print_row(const std::string& name, const Problem& problem, const Settings& settings) {
  const Solved ours = run(problem, make_multigrid_solver);
  std::printf("| %s | %zu | %zu | %.0f | %.0f | %.0f ", name.c_str(), problem.positions.size(),
              problem.anchors.size(), ours.setup_ns, ours.solve_ns, ours.setup_ns + ours.solve_ns);
  if (problem.positions.size() <= settings.largest_direct) {
    const Solved direct = run(problem, make_direct_solver);
    const double error = rms_difference(direct.x, problem.positions);
    std::printf(
        "| %.0f | %.4f | %.4f | %.4f |\n", direct.setup_ns + direct.solve_ns,
        rms_difference(ours.x, direct.x) / error, rms_difference(ours.x, problem.positions) / error,
        largest_difference(ours.x, problem.positions) / largest_difference(direct.x, problem.positions));
  } else {
    std::printf("| | | | |\n");
  }
  std::fflush(stdout);
}

/// About `n` vertices of rough terrain, diagonals of the squares either way.
Problem terrain(std::uint32_t n, const Settings& settings) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n)));
  std::uint32_t state = 1;
  const auto random = [&state] { return (state = state * 1664525 + 1013904223) >> 8; };
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x)
      positions.push_back({static_cast<double>(x) - 0.5 * side, static_cast<double>(y) - 0.5 * side,
                           10 * std::sin(0.02 * x) * std::cos(0.03 * y) + std::ldexp(random(), -24)});
  }
  for (std::uint32_t y = 0; y + 1 < side; ++y) {
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x;
      if (random() % 2 == 0) {
        triangles.insert(triangles.end(), {a, a + 1, a + side, a + 1, a + side + 1, a + side});
      } else {
        triangles.insert(triangles.end(), {a, a + 1, a + side + 1, a, a + side + 1, a + side});
      }
    }
  }
  return make_problem(triangles, positions, settings);
}

void print_corpus(const Settings& settings) {
  for (const char* folder : {"paper", "models", "robot"}) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(settings.corpus) / folder))
      if (entry.path().extension() == ".ply") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
      auto mesh = bench::load_welded(file.string());
      if (!mesh) {
        std::fprintf(stderr, "%s: %s\n", file.c_str(), describe(mesh.error()).c_str());
        continue;
      }
      const Vec3 center = 0.5 * (mesh->box.min + mesh->box.max);
      for (Vec3& position : mesh->positions) position = position - center;
      print_row(file.stem().string(), make_problem(mesh->triangles, mesh->positions, settings), settings);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("Compares the solvers of highpass streams.");
  app.add_option("--corpus", settings.corpus, "folder of the mesh corpus; without it generated terrain only");
  app.add_option("--anchors", settings.anchor_percent, "percent of the vertices that are anchors");
  app.add_option("--bits", settings.bits, "bits of the delta quantiser")->check(CLI::Range(3, 16));
  app.add_option("--largest", settings.largest, "vertices of the largest generated terrain");
  app.add_option("--largest-direct", settings.largest_direct, "no factorisation above so many vertices");
  CLI11_PARSE(app, argc, argv);

  std::printf(
      "| mesh | vertices | anchors | setup ns/vertex | solve | total | direct total | rms from exact / LFE "
      "| LFE over exact | largest error over exact |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::uint32_t n : {10000U, 50000U, 250000U, 1000000U, 4000000U}) {
    if (n <= settings.largest) print_row("terrain", terrain(n, settings), settings);
  }
  if (!settings.corpus.empty()) print_corpus(settings);
}
