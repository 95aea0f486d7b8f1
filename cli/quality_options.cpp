// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality_options.h"

#include <cstdlib>
#include <string>

namespace deltamesh::cli {
namespace {

/// "0.002" in model units, "0.02%" of the diagonal. Empty where it is neither.
std::optional<QualityBound> parse_bound(const std::string& text) {
  char* end = nullptr;
  QualityBound bound{.value = std::strtod(text.c_str(), &end)};
  if (end == text.c_str()) return std::nullopt;
  const std::string rest = end;
  if (rest == "%") bound.unit = QualityUnit::kDiagonal;
  if (!rest.empty() && rest != "%") return std::nullopt;
  return bound;
}

/// What is wrong with `text`; empty where nothing is.
std::string in_model_units(const std::string& text) {
  const auto bound = parse_bound(text);
  if (bound && bound->unit == QualityUnit::kModel) return {};
  return "must be a number of model units, without a %: " + text;
}

void add_bound(CLI::App& command, const std::string& name, const std::string& what,
               std::optional<QualityBound>& bound) {
  CLI::Option* plain = command.add_option_function<std::string>(
      name,
      [&bound, name](const std::string& text) {
        bound = parse_bound(text);
        if (!bound) throw CLI::ValidationError(name, "not a number, nor a number and %: " + text);
      },
      "largest " + what + " (rms): model units, or percent of the diagonal with a % behind");
  plain->type_name("NUMBER[%]");
  command
      .add_option_function<double>(
          name + "-paper",
          [&bound](const double& value) {
            bound = QualityBound{.value = value, .unit = QualityUnit::kPaper};
          },
          "the same as the paper's sum, the mesh scaled to a diagonal of 1")
      ->excludes(plain);
}

}  // namespace

void add_quality_options(CLI::App& command, QualityRequest& request) {
  add_bound(command, "--vde", "visual distortion error", request.vde);
  add_bound(command, "--lfe", "low-frequency error", request.lfe);
  command.add_option("--max-error", request.max_error, "no vertex is farther off, model units")
      ->check(CLI::Validator(in_model_units, "NUMBER", "model units"));
  command.add_option("--target-bytes", request.target_bytes,
                     "most bytes of the stream; alone: the best quality that fits");
}

}  // namespace deltamesh::cli
