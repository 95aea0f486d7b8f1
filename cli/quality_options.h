// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The options that ask for a quality.
#pragma once

#include <CLI/CLI.hpp>

#include "deltamesh/quality_request.h"

namespace deltamesh::cli {

/// Adds --vde, --lfe, --vde-paper, --lfe-paper, --max-error and --target-bytes, which fill `request`; it must
/// outlive `command`.
void add_quality_options(CLI::App& command, QualityRequest& request);

}  // namespace deltamesh::cli
