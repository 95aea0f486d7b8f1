// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The report for people.
#pragma once

#include <string>

#include "curves/run.h"

namespace deltamesh::bench {

/// Where and with what it was measured; sizes at equal quality; geometric means; a table for every mesh;
/// failures.
std::string render_markdown(const Run& run);

/// RFC 4180 with a header line; errors in model units and in percent of the diagonal, times in seconds.
std::string render_csv(const Run& run);

}  // namespace deltamesh::bench
