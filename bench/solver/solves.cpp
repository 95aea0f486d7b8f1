// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "solver/solves.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "highpass/highpass.h"
#include "laplacian/solver.h"
#include "report/table.h"
#include "report/text.h"
#include "scenes.h"
#include "solver/decode_race.h"
#include "solver/problem.h"
#include "support/command_line.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

struct Settings {
  std::string corpus;
  std::vector<std::uint64_t> sizes{10000, 50000, 250000, 1000000};
  std::vector<std::string> scenes{"rooms", "terrain", "sphere", "cad", "fragments"};
  std::vector<double> anchor_percents{0.2, 1};
  std::vector<int> bits{4, 8};
  std::vector<double> diffusions{0, 1};
  std::uint64_t largest_direct = 300000;
  bool race = false;
};

struct Solved {
  double setup_ns = 0;  ///< per vertex
  double solve_ns = 0;
  std::vector<Vec3> x;
};

/// `make`: gives a solver; `solve`: has it solve into x, and says whether it could.
template <class Make, class Solve>
Solved run(const Problem& problem, Make make, Solve solve) {
  Solved solved;
  solved.x.resize(problem.positions.size());
  const double per_vertex = 1e9 / static_cast<double>(problem.positions.size());
  const double start = processor_seconds();
  auto solver = make();
  const double ready = processor_seconds();
  if (solve(solver, std::span(solved.x))) {
    solved.setup_ns = (ready - start) * per_vertex;
    solved.solve_ns = (processor_seconds() - ready) * per_vertex;
  }
  return solved;
}

Solved run_cycles(const Problem& problem, int cycles) {
  const auto make = [&] {
    return SingleSolve({problem.part.graph, problem.part.components}, problem.anchors, cycles);
  };
  return run(problem, make, [&](SingleSolve& solver, std::span<Vec3> x) {
    const auto solved = std::move(solver).solve(problem.deltas, problem.targets, x.size());
    if (solved) std::ranges::copy(*solved, x.begin());
    return solved.has_value();
  });
}

Solved run_directly(const Problem& problem) {
  const auto make = [&] { return test::DirectSolver(problem.part.graph, problem.anchors); };
  return run(problem, make, [&](const auto& solver, std::span<Vec3> x) {
    solver.solve(problem.deltas, problem.targets, x);
    return true;
  });
}

/// What an encoder makes of the problem, and what it would be without a plan.
struct Coded {
  CodedHighpass settled;
  CodedHighpass best;
};

std::optional<Coded> code(const Problem& problem) {
  const Components components = find_components(problem.whole);
  AnchorSequence anchors(problem.whole, components);
  HighpassCoder coder(problem.whole, components, anchors, problem.whole_positions, problem.box);
  auto settled = coder.code(problem.settings);
  if (!settled) return std::nullopt;
  auto planned = coder.plan(problem.settings, settled->positions, [](const CodedHighpass&) { return true; });
  return Coded{.settled = *settled, .best = planned ? *std::move(planned) : *settled};
}

double delta_bits(const CodedHighpass& coded, const Problem& problem) {
  return 8.0 * static_cast<double>(coded.compact_deltas.size()) /
         static_cast<double>(problem.positions.size());
}

void print_row(const std::string& name, const Problem& problem, const ProblemSettings& how,
               const Settings& settings) {
  const auto coded = code(problem);
  if (!coded) return;
  const int cycles = coded->best.parameters.cycles;
  const Solved settled = run_cycles(problem, 0);
  const Solved ours = run_cycles(problem, cycles);
  Cells cells{name,
              number(problem.positions.size()),
              number(how.bits),
              significant(how.anchor_percent, 6),
              significant(how.diffusion, 6),
              number(problem.anchors.size()),
              number(cycles),
              fixed(ours.setup_ns, 0),
              fixed(ours.solve_ns, 0),
              fixed(ours.setup_ns + ours.solve_ns, 0),
              fixed(settled.setup_ns + settled.solve_ns, 0),
              fixed(delta_bits(coded->settled, problem), 3),
              fixed(delta_bits(coded->best, problem), 3)};
  if (problem.positions.size() <= settings.largest_direct) {
    const Solved direct = run_directly(problem);
    const std::vector<Vec3> x = problem.solved_of(coded->best.positions);
    const auto over = [&](auto difference) {
      return fixed(difference(x, problem.positions) / difference(direct.x, problem.positions), 4);
    };
    cells.insert(cells.end(), {fixed(direct.setup_ns + direct.solve_ns, 0), over(rms_difference),
                               over(largest_difference)});
  }
  cells.resize(16);
  print(table_row(cells));
}

void print_solves(const MeshSource& source, const Settings& settings) {
  const auto mesh = source.load();
  if (!mesh) return;
  for (const int bits : settings.bits) {
    for (const double anchor_percent : settings.anchor_percents) {
      for (const double diffusion : settings.diffusions) {
        const ProblemSettings how{.anchor_percent = anchor_percent, .bits = bits, .diffusion = diffusion};
        const Problem problem = make_problem(*mesh, how);
        if (!problem.positions.empty()) print_row(source.name, problem, how, settings);
      }
    }
  }
}

std::vector<MeshSource> choose_meshes(const Settings& settings) {
  if (!settings.corpus.empty()) return corpus_meshes(settings.corpus);
  std::vector<MeshSource> sources;
  for (const std::uint64_t size : settings.sizes) {
    for (const std::string& name : settings.scenes) {
      const Scene scene = *scene_of_name(name);
      sources.push_back({.name = name, .load = [scene, size] { return generate_scene(scene, size, 1); }});
    }
  }
  return sources;
}

int run_benchmark(const Settings& settings) {
  const std::vector<MeshSource> sources = choose_meshes(settings);
  if (settings.race) {
    print_decode_race_header();
    for (const MeshSource& source : sources) {
      const auto mesh = source.load();
      if (mesh) print_decode_race(source.name, welded_geometry(*mesh));
    }
    return 0;
  }
  print(table_head({"mesh", "vertices", "bits", "anchors %", "diffusion", "anchors", "cycles",
                    "setup ns/vertex", "solve", "total", "total without a plan",
                    "bits per vertex of deltas without a plan", "with it", "direct total", "LFE over exact",
                    "largest error over exact"}));
  for (const MeshSource& source : sources) print_solves(source, settings);
  return 0;
}

}  // namespace

int run_solver_bench(int argc, char** argv) {
  Settings settings;
  CLI::App app("Times the solver of highpass streams and compares its solutions with a direct one.",
               "deltamesh_micro solver");
  app.add_option("--corpus", settings.corpus, "folder of the mesh corpus; without it generated scenes");
  app.add_option("--sizes", settings.sizes, "vertices of the generated scenes")->capture_default_str();
  app.add_option("--scenes", settings.scenes, "which scenes")
      ->delimiter(',')
      ->check([](const std::string& name) {
        return scene_of_name(name) ? std::string() : "no such scene: " + name;
      })
      ->capture_default_str();
  app.add_option("--anchors", settings.anchor_percents, "percent of the vertices that are anchors")
      ->capture_default_str();
  app.add_option("--bits", settings.bits, "bits of the delta quantiser")->capture_default_str();
  app.add_option("--diffusion", settings.diffusions, "strengths of the error diffusion")
      ->capture_default_str();
  app.add_option("--largest-direct", settings.largest_direct, "no factorisation above so many vertices")
      ->capture_default_str();
  app.add_flag("--race", settings.race, "instead: whole decodes (8 bits, 0.5 % anchors) beside Draco's");
  return parse_and_run(app, argc, argv, [&] { return run_benchmark(settings); });
}

}  // namespace deltamesh::bench
