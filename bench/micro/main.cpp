// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// deltamesh_micro: the stages of the codec one by one, by Google Benchmark; `solver`: tables of the solver.
#include <benchmark/benchmark.h>

#include <string_view>

#include "solver/solves.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "solver")
    return deltamesh::bench::run_solver_bench(argc - 1, argv + 1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
