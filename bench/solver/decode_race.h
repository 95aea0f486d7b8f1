// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole decodes, ours beside Draco's, of one mesh: time and peak memory.
#pragma once

#include <string>

#include "deltamesh/mesh.h"

namespace deltamesh::bench {

/// Prints one row of a Markdown table: vertices, nanoseconds per vertex (processor time, and with two threads
/// the time that passes) and peak memory above the idle process's of both decoders, and the ratios. Times are
/// medians of rounds in which one decodes after the other, ratios those of the rounds' ratios. Beside
/// them is how much of both is the system's time, for handing out and clearing memory.
void print_decode_race(const std::string& name, const Mesh& mesh);

void print_decode_race_header();

}  // namespace deltamesh::bench
