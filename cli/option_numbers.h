// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers on the command line, as people write them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/quality_request.h"

namespace deltamesh::cli {

/// "0.002" or "1/4096"; empty where the text is neither.
std::optional<double> parse_number(const std::string& text);

/// A number in model units; with a % behind, of the diagonal; or "none" for kNoBound. Empty where it is none
/// of these.
std::optional<QualityBound> parse_bound(const std::string& text);

/// What parse_bound() makes the same bound of.
std::string text_of(const QualityBound& bound);

/// "NAME=NUMBER", split at the last "="; empty where it has another form.
std::optional<NamedBound> parse_named_bound(const std::string& text);

/// Adds an option whose value is a number of parse_number(); `set` gets it while the line is parsed.
CLI::Option* add_number(CLI::App& command, const std::string& name, const std::string& what,
                        std::function<void(double)> set);

/// The same for parse_bound().
CLI::Option* add_bound(CLI::App& command, const std::string& name, const std::string& what,
                       std::optional<QualityBound>& bound);

/// A check of an option that counts: what to say of a negative number, else nothing. (The parser would take
/// -1 for the largest number.)
std::string refuse_negative(const std::string& text);

}  // namespace deltamesh::cli
