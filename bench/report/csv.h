// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All measurements, one line each.
#pragma once

#include <string>

#include "run/run.h"

namespace deltamesh::bench {

/// RFC 4180 with a header line; errors in model units and in percent of the diagonal, times in seconds.
std::string render_csv(const Run& run);

}  // namespace deltamesh::bench
