// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/console.h"

#include <algorithm>
#include <cstdio>

namespace deltamesh::cli {

void print_error(std::string_view subject, std::string_view what) {
  std::cerr << "deltamesh: " << subject << ": " << what << '\n';
}

ExitCode fail(std::string_view subject, const Error& error) {
  print_error(subject, describe(error));
  return exit_code_of(error.code);
}

void print_json(const nlohmann::ordered_json& object, std::ostream& out) {
  out << object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t from_end = 3; from_end < digits.size(); from_end += 4)
    digits.insert(digits.size() - from_end, 1, ',');
  return digits;
}

std::string counted(std::uint64_t number, std::string_view one, std::string_view many) {
  return grouped(number) + ' ' + std::string(number == 1 ? one : many);
}

std::string brief(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

std::string of_diagonal(double length, double diagonal) {
  if (!(diagonal > 0)) return brief(length);
  return brief(length) + " (" + brief(100 * length / diagonal) + " % of the diagonal)";
}

void Summary::print(std::ostream& out) const {
  std::size_t width = 0;
  for (const Line& line : lines_) width = std::max(width, line.label.size());
  out << headline_ << '\n';
  for (const Line& line : lines_)
    out << "  " << line.label << std::string(width - line.label.size() + 2, ' ') << line.value << '\n';
}

}  // namespace deltamesh::cli
