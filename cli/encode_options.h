// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The options of the encoder, alike for every command that compresses.
#pragma once

#include <CLI/CLI.hpp>

#include "deltamesh/encode.h"
#include "deltamesh/map/part_quality.h"

namespace deltamesh::cli {

/// Adds every option of the encoder; they fill `options`, which must outlive `command`. Contradictions that
/// the parser does not see are validate()'s to find.
void add_encode_options(CLI::App& command, EncodeOptions& options);

/// Whether the command line has any bound on attributes.
bool asks_of_attributes(const CLI::App& command);

/// Those of them that a part of a map has.
void add_part_quality(CLI::App& command, PartQuality& quality);

}  // namespace deltamesh::cli
