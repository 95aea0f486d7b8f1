// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "option_numbers.h"

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

namespace deltamesh::cli {
namespace {

/// The number at the front of `text`; `rest` gets what stands behind it. Empty where there is none.
std::optional<double> leading_number(const std::string& text, std::string& rest) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return std::nullopt;
  rest = end;
  return value;
}

}  // namespace

std::optional<double> parse_number(const std::string& text) {
  std::string rest;
  const std::optional<double> value = leading_number(text, rest);
  if (!value || rest.empty()) return value;
  if (rest.front() != '/') return std::nullopt;
  std::string behind;
  const std::optional<double> divisor = leading_number(rest.substr(1), behind);
  if (!divisor || !behind.empty()) return std::nullopt;
  return *value / *divisor;
}

std::optional<QualityBound> parse_bound(const std::string& text) {
  if (text == "none") return kNoBound;
  const bool is_percent = text.ends_with('%');
  const std::optional<double> value = parse_number(is_percent ? text.substr(0, text.size() - 1) : text);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return QualityBound{.value = *value, .unit = is_percent ? QualityUnit::kDiagonal : QualityUnit::kModel};
}

std::string text_of(const QualityBound& bound) {
  if (bound.value == kNoBound.value) return "none";
  return nlohmann::json(bound.value).dump() + (bound.unit == QualityUnit::kDiagonal ? "%" : "");
}

std::optional<NamedBound> parse_named_bound(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) return std::nullopt;
  const std::optional<double> error = parse_number(text.substr(equals + 1));
  if (!error) return std::nullopt;
  return NamedBound{.name = text.substr(0, equals), .error = *error};
}

CLI::Option* add_number(CLI::App& command, const std::string& name, const std::string& what,
                        std::function<void(double)> set) {
  return command
      .add_option_function<std::string>(
          name,
          [name, set = std::move(set)](const std::string& text) {
            const std::optional<double> value = parse_number(text);
            if (!value) throw CLI::ValidationError(name, "not a number: " + text);
            set(*value);
          },
          what)
      ->type_name("NUMBER");
}

CLI::Option* add_bound(CLI::App& command, const std::string& name, const std::string& what,
                       std::optional<QualityBound>& bound) {
  return command
      .add_option_function<std::string>(
          name,
          [&bound, name](const std::string& text) {
            bound = name == "--max-error" || text != "none" ? parse_bound(text) : std::nullopt;
            if (!bound) throw CLI::ValidationError(name, "not a number, nor a number and %: " + text);
          },
          what)
      ->type_name("NUMBER[%]");
}

std::string refuse_negative(const std::string& text) {
  return text.starts_with('-') ? "Value " + text + " is negative" : "";
}

}  // namespace deltamesh::cli
