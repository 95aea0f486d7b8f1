// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solve_once.h"

#include <utility>

#include "base/task.h"
#include "base/try.h"
#include "laplacian/solver.h"

namespace deltamesh {

Result<LargeVector<Vec3>> solve_once(LeastSquaresProblem problem, const ReadSymbols& read_symbols,
                                     std::size_t size, ThreadTeam* team) {
  Task reading(team, [&] { return read_symbols(problem.graph); });
  DELTAMESH_TRY(const auto solver, make_solver_for_components(problem.graph, std::move(problem.components),
                                                              problem.anchors, team));
  solver->set_up(problem.cycles);
  DELTAMESH_TRY(const SymbolRows symbols, reading.get());
  return solver->solve_last(DeltaView(symbols.view(), problem.scale), problem.targets, problem.cycles, size);
}

}  // namespace deltamesh
