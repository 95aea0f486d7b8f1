// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Everything that one run of the benchmark found out: what the reports are written from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "run/measure.h"

namespace deltamesh::bench {

/// A peer that did not get through.
struct Failure {
  std::string mesh;
  std::string peer;  ///< and setting; empty where the mesh itself could not be had
  std::string reason;
};

struct Run {
  std::string meshes;                     ///< in words: which meshes these are
  TimingEffort timing;                    ///< how often each time was taken
  std::vector<Measurement> measurements;  ///< mesh by mesh, in the order of the ladder
  std::vector<Failure> failures;
};

/// Names of the measured meshes, in order, each once.
std::vector<std::string> mesh_names(const Run& run);

/// Names of the peers in order of first appearance.
std::vector<std::string> peer_names(const Run& run);

}  // namespace deltamesh::bench
