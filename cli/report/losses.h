// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What readers and writers of mesh files leave out, for people and machines.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "deltamesh/io.h"

namespace deltamesh::cli {

/// "names of materials (2), face values flags (12)"; empty where nothing is left out.
std::string left_out_text(const LossReport& report);

/// A line with it under a headline; nothing where nothing is left out.
void print_left_out(const LossReport& report, std::ostream& out);

/// How far coordinates of the mesh file were moved as they became float32, which figures of decoded meshes do
/// not count; nothing for 0.
void print_rounding(double most, std::ostream& out);

/// How many times KHR_texture_transform stretches texture coordinates; nothing for 1.
void print_stretch(double uv_scale, std::ostream& out);

/// How many vertices no face uses: those that maps drop. O(n).
std::uint64_t count_unreferenced(const Mesh& mesh);

/// "1,113 vertices that no face uses were dropped"; `fate`: "dropped" or "kept".
std::string unreferenced_text(std::uint64_t count, const char* fate);

/// A line with it under a headline; nothing for 0.
void print_dropped(std::uint64_t unreferenced, std::ostream& out);

/// [{"kind": "names", "name": "materials", "count": 2}, ...]
nlohmann::ordered_json left_out_array(const LossReport& report);

}  // namespace deltamesh::cli
