// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is told of the attributes of a stream or of a comparison: kinds, types, units of their errors.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "deltamesh/compare.h"
#include "deltamesh/stream_info.h"
#include "report/console.h"

namespace deltamesh::cli {

/// "normal", "color", "uv", "tangent", "joints", "weights" or "generic".
std::string kind_text(AttributeKind kind);

/// "3 x f32".
std::string shape_text(ComponentType type, int components);

/// Unit of an error of this kind, for JSON: "degrees", "uv" (distance), "255ths" or "value".
const char* unit_name(AttributeKind kind);

/// "0.49 degrees", "1.5 of 255", "0.001"; "exact" where it is 0.
std::string error_text(AttributeKind kind, double error);

/// "exact", "max error 4 of 255", "photographic, 41 dB, max error 30 of 255". `rms`: of AttributeInfo.
std::string kept_text(AttributeKind kind, double error, double rms);

/// A line for every attribute. `labels`: of EncodeReport.
void add_attributes(Summary& summary, const StreamInfo& info, std::uint64_t labels = 0);
/// "12 lengths of normals or tangents other than 1 ...".
std::string lengths_text(std::uint64_t count);
/// Of EncodeReport; nothing where it is 0.
void add_dropped_lengths(Summary& summary, std::uint64_t count);
void add_attributes(Summary& summary, const Comparison& result);

/// The same as an array of objects.
nlohmann::ordered_json attributes_object(const StreamInfo& info);
nlohmann::ordered_json attributes_object(const Comparison& result);

}  // namespace deltamesh::cli
