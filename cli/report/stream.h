// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is told of a stream, alike after encoding and on inspection.
#pragma once

#include <nlohmann/json.hpp>

#include "deltamesh/stream_info.h"
#include "report/console.h"

namespace deltamesh::cli {

/// 0 where there are no vertices.
double bits_per_vertex(std::uint64_t bytes, const StreamInfo& info);

/// "1,234 bytes, 5.67 bits per vertex".
std::string size_text(std::uint64_t bytes, const StreamInfo& info);

/// Adds counts, sizes, settings and achieved errors.
void add_stream(nlohmann::ordered_json& object, const StreamInfo& info);

/// The same for people.
void add_extent(Summary& summary, const StreamInfo& info);  ///< where there are stray vertices
void add_sizes(Summary& summary, const StreamInfo& info);
void add_settings(Summary& summary, const StreamInfo& info);
void add_errors(Summary& summary, const Quality& quality, double diagonal);

}  // namespace deltamesh::cli
