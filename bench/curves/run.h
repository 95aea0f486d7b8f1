// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Everything that one run of the benchmark found out: what the reports are written from.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "peers/measure.h"

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

/// The errors that sizes are set against: a plot and a table for each.
struct ErrorKind {
  const char* name;  ///< "VDE"
  const char* slug;  ///< in file names
  double Quality::*member;

  /// Percent of the bounding box's diagonal.
  double percent(const Measurement& measurement) const {
    return measurement.percent(measurement.quality.*member);
  }
};

inline constexpr std::array<ErrorKind, 2> kErrorKinds = {
    ErrorKind{.name = "VDE", .slug = "vde", .member = &Quality::vde_rms},
    ErrorKind{.name = "LFE", .slug = "lfe", .member = &Quality::lfe_rms}};

/// Names of the measured meshes, in order, each once.
std::vector<std::string> mesh_names(const Run& run);

/// Names of the peers in order of first appearance.
std::vector<std::string> peer_names(const Run& run);

}  // namespace deltamesh::bench
