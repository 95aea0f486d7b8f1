// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The paper's Tables 1 and 2 with our figures, and the data of its Figures 3, 6 and 7.
#pragma once

#include <string>

namespace deltamesh::bench {

/// Prints the tables of CORPUS/paper; writes figures and data as CSV and SVG into `out` unless it is empty.
/// Returns 0, 4 where it cannot write; exits where a mesh cannot be read or coded.
int reproduce_paper(const std::string& corpus, const std::string& out);

}  // namespace deltamesh::bench
