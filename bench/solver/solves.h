// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The solver of highpass streams, as Markdown tables: time per vertex, what is left of the exact solution and
// what that does to the errors; and whole decodes beside Draco's.
#pragma once

namespace deltamesh::bench {

/// `deltamesh_micro solver`. Returns the exit status.
int run_solver_bench(int argc, char** argv);

}  // namespace deltamesh::bench
