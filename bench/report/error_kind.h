// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The errors that sizes are set against: a plot and a table for each.
#pragma once

#include <array>

#include "run/measure.h"

namespace deltamesh::bench {

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

}  // namespace deltamesh::bench
