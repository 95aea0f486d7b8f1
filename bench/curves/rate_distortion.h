// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rate-distortion plots: bits per vertex against an error.
#pragma once

#include <optional>
#include <string>

#include "curves/run.h"
#include "report/svg_plot.h"

namespace deltamesh::bench {

/// One line per peer (the lower hull of its settings), one marker per setting. A peer far off to the right,
/// whose smallest size is half as large again as our largest, is named below the plot instead. Nothing where
/// no measurement of `mesh` has an error above 0.
std::optional<Plot> rate_distortion_plot(const Run& run, const std::string& mesh, const ErrorKind& kind);

}  // namespace deltamesh::bench
