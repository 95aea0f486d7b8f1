// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the program says: errors on stderr, results on stdout, for people or as JSON.
#pragma once

#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/result.h"
#include "exit_codes.h"

namespace deltamesh::cli {

/// Prints `deltamesh: SUBJECT: WHAT` to stderr. `subject`: the file concerned, or an option.
void print_error(std::string_view subject, std::string_view what);

/// The same for an error of the library; returns the program's exit code for it.
ExitCode fail(std::string_view subject, const Error& error);

/// Prints one object, to standard output where nothing else is said. NaN and infinity become null.
void print_json(const nlohmann::ordered_json& object, std::ostream& out = std::cout);

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);

/// "1 vertex", "2,000 vertices".
std::string counted(std::uint64_t number, std::string_view one, std::string_view many);

/// Four significant digits.
std::string brief(double number);

/// Numbers as brief() writes them.
template <class Numbers>
std::string brief_list(const Numbers& numbers, const char* between) {
  std::string text;
  for (const auto number : numbers)
    text += (text.empty() ? "" : between) + brief(static_cast<double>(number));
  return text;
}

/// "0.01234 (0.05 % of the diagonal)"; the length alone where the diagonal is 0.
std::string of_diagonal(double length, double diagonal);

/// A headline and aligned lines of label and value.
class Summary {
 public:
  explicit Summary(std::string headline) : headline_(std::move(headline)) {}
  void add(std::string label, std::string value) { lines_.push_back({std::move(label), std::move(value)}); }
  void print(std::ostream& out = std::cout) const;

 private:
  struct Line {
    std::string label;
    std::string value;
  };
  std::string headline_;
  std::vector<Line> lines_;
};

}  // namespace deltamesh::cli
