// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tables line by line, as Markdown and as CSV.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace deltamesh::bench {

using Cells = std::vector<std::string>;

/// The names of a Markdown table's columns. The first `texts` columns are aligned left, figures right.
std::string table_head(const Cells& names, std::size_t texts = 1);

std::string table_row(const Cells& cells);

/// RFC 4180; `cells` need no quotes or have them.
std::string csv_row(const Cells& cells);

/// `text` in quotes.
std::string quoted(const std::string& text);

/// Prints `text` at once: runs are long, and are watched.
void print(const std::string& text);

}  // namespace deltamesh::bench
