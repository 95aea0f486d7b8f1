// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The options of the encoder, alike for every command that compresses.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "deltamesh/encode.h"
#include "deltamesh/map/part_quality.h"

namespace deltamesh::cli {

/// Adds every option of the encoder; they fill `options`, which must outlive `command`. Contradictions that
/// the parser does not see are validate()'s to find.
void add_encode_options(CLI::App& command, EncodeOptions& options);

/// Whether the command line has any bound on attributes.
bool asks_of_attributes(const CLI::App& command);

/// Whether `mesh`, of the file at `path`, has an attribute for every bound that names one, and of a kind that
/// has no option of its own; if not, says so. `kept_in`: the file that the bounds are from; empty: options.
bool check_named_bounds(const AttributeQuality& quality, const std::string& path, const Mesh& mesh,
                        int& status, const std::string& kept_in = {});

/// Those of them that a part of a map has.
void add_part_quality(CLI::App& command, PartQuality& quality);

}  // namespace deltamesh::cli
