// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All output files of a run.
#pragma once

#include <string>

#include "deltamesh/result.h"
#include "run/run.h"

namespace deltamesh::bench {

/// Writes results.csv, results.md and, for every mesh and kind of error, plots/<mesh>.<kind>.svg ('/' in
/// names becomes '-') into `folder`, which is made where absent. Errors: kFileWrite.
Result<void> write_reports(const Run& run, const std::string& folder);

}  // namespace deltamesh::bench
