// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encode_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "exit_codes.h"
#include "option_numbers.h"
#include "report/attributes.h"
#include "report/console.h"
#include "stored/json_value.h"

namespace deltamesh::cli {
namespace {

constexpr const char* kPositions = "Quality of positions";
constexpr const char* kAttributes = "Quality of attributes (largest errors; 0 is exact)";
/// All that bound attributes, which `--lossless` excludes.
constexpr std::array kAttributeOptions{"--normal-error", "--tangent-error",   "--uv-error",
                                       "--color-error",  "--color-rms",       "--color-psnr",
                                       "--weight-error", "--attribute-error", "--attribute-rms"};
constexpr const char* kSettings = "Settings for experiments";

GeometryCoder geometry_coder(const std::string& name) {
  if (name == "highpass") return GeometryCoder::kHighpass;
  return name == "predictive" ? GeometryCoder::kPredictive : GeometryCoder::kAuto;
}

void add_paper_bound(CLI::App& command, const std::string& name, std::optional<QualityBound>& bound) {
  const auto set = [&bound](double value) {
    bound = QualityBound{.value = value, .unit = QualityUnit::kPaper};
  };
  add_number(command, name + "-paper", "as " + name + ", as the paper's sum: the mesh has a diagonal of 1",
             set)
      ->excludes(name)
      ->group(kSettings);
}

void add_bounds(CLI::App& command, QualityRequest& request) {
  add_bound(command, "--max-error",
            "largest distance of a vertex from its place: model units, or percent of the diagonal with a % "
            "behind; 0.02% where nothing else is asked for, 1% for --vde without --lfe; \"none\" for no "
            "limit there",
            request.max_error)
      ->group(kPositions);
  add_bound(command, "--vde", "largest visual distortion error (rms), in the same units", request.vde)
      ->group(kPositions);
  add_bound(command, "--lfe", "largest low-frequency error (rms), in the same units", request.lfe)
      ->group(kPositions);
}

void add_position_quality(CLI::App& command, QualityRequest& request) {
  add_bounds(command, request);
  command
      .add_option("--target-bytes", request.target_bytes,
                  "most bytes of a stream, or of all of an asset's together; alone: the best quality that "
                  "fits, where errors of attributes grow with those of positions unless bounds are given")
      ->check(refuse_negative)
      ->group(kPositions);
}

/// An option that may be given once for each name.
void add_named_bounds(CLI::App& command, const std::string& option, const std::string& what, bool is_mean,
                      std::vector<NamedBound>& bounds) {
  const auto add = [option, is_mean, &bounds](const std::string& text) {
    std::optional<NamedBound> bound = parse_named_bound(text);
    if (!bound) throw CLI::ValidationError(option, "not NAME=NUMBER: " + text);
    if (!fits_json(bound->name)) throw CLI::ValidationError(option, "the attribute's name is not UTF-8");
    const auto same_name = [&](const NamedBound& other) { return other.name == bound->name; };
    if (std::any_of(bounds.begin(), bounds.end(), same_name))
      throw CLI::ValidationError(option, "given twice for " + bound->name);
    bound->is_mean = is_mean;
    bounds.push_back(*std::move(bound));
  };
  command
      .add_option_function<std::vector<std::string>>(
          option, [add](const std::vector<std::string>& texts) { std::ranges::for_each(texts, add); }, what)
      ->type_name("NAME=NUMBER")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group(kAttributes);
}

void add_attribute_quality(CLI::App& command, AttributeQuality& quality) {
  const auto add = [&](const std::string& name, const char* what, const char* value, auto set) {
    add_number(command, name, what, set)->default_str(value)->group(kAttributes);
  };
  add("--normal-error", "of normals: angle, degrees", "0.5", [&](double x) { quality.normal_error = x; });
  add("--tangent-error", "of tangents: angle, degrees; default: as normals", "",
      [&](double x) { quality.tangent_error = x; });
  add("--uv-error", "of texture coordinates: distance in their units", "1/4096",
      [&](double x) { quality.uv_error = x; });
  add("--color-error",
      "of a component of a colour: 255ths of its range; default: 0 for labels, 41 dB for photographs", "",
      [&](double x) { quality.color_error = x; });
  CLI::Option* const rms = add_number(command, "--color-rms",
                                      "instead: root mean square of the errors of red, green and blue, "
                                      "255ths",
                                      [&](double x) { quality.color_rms = x; });
  CLI::Option* const psnr = add_number(command, "--color-psnr", "the same in decibels: 20 log10(255 / rms)",
                                       [&](double x) { quality.color_rms = 255 * std::pow(10, -x / 20); });
  for (CLI::Option* option : {rms, psnr}) option->excludes("--color-error")->group(kAttributes);
  psnr->excludes(rms);
  add("--weight-error", "of a skinning weight; sums of 1 stay 1, weights with other sums are exact", "1/1024",
      [&](double x) { quality.weight_error = x; });
  add_named_bounds(command, "--attribute-error",
                   "of a component of the attribute NAME, such as intensity; otherwise exact; once for each "
                   "name",
                   false, quality.named);
  add_named_bounds(command, "--attribute-rms",
                   "instead: root mean square of the errors of NAME, which has one component; fewer bytes at "
                   "the same mean error",
                   true, quality.named);
}

void add_settings(CLI::App& command, EncodeOptions& options) {
  CLI::Option* bits = command.add_option("--bits", options.bits,
                                         "bits of the delta coordinates, 3 (coarse) to 16 (fine); "
                                         "predictive: of the longest side, 1 to 28");
  CLI::Option* step =
      command.add_option("--step", options.step, "instead: the quantisation step, model units");
  CLI::Option* anchors = command.add_option(
      "--anchors", options.anchors, "number of anchors; default 0.5 % of the vertices, less for a quality");
  CLI::Option* density =
      command.add_option("--anchor-density", options.anchor_density,
                         "instead: most edges from a vertex to its nearest anchor, 1 to 65535");
  CLI::Option* anchor_bits =
      command.add_option("--anchor-bits", options.anchor_bits, "bits per axis of an anchor, 4 to 24")
          ->capture_default_str();
  step->excludes(bits);
  density->excludes(anchors);
  for (CLI::Option* option : {bits, step, anchors, density, anchor_bits}) option->group(kSettings);
  add_paper_bound(command, "--vde", options.quality.vde);
  add_paper_bound(command, "--lfe", options.quality.lfe);
}

void add_search(CLI::App& command, GeometryCoder& coder, int& effort) {
  command
      .add_option_function<std::string>(
          "--geometry", [&coder](const std::string& name) { coder = geometry_coder(name); },
          "coder of the positions: highpass looks best, predictive bounds each vertex's error and decodes "
          "fastest; auto takes the smaller for the quality asked for")
      ->check(CLI::IsMember({"auto", "highpass", "predictive"}))
      ->default_str("auto");
  command
      .add_option("--effort", effort,
                  "how hard to look for a smaller stream: 0 (few passes, for a robot's computer), 1, or 2")
      ->capture_default_str();
}

void add_coders(CLI::App& command, EncodeOptions& options) {
  add_search(command, options.geometry, options.effort);
  command
      .add_option_function<std::string>(
          "--profile",
          [&options](const std::string& name) {
            options.profile = name == "zstd" ? Profile::kZstd : Profile::kSmallest;
          },
          "form of the stream: zstd is plain arrays, larger, which others read in a page")
      ->check(CLI::IsMember({"smallest", "zstd"}))
      ->default_str("smallest");
  command.add_flag("--keep-order", options.keep_order,
                   "restore the order of vertices and faces exactly, in several times the bytes");
  command.add_flag("--keep-unreferenced", options.keep_unreferenced, "keep vertices that no face uses");
}

}  // namespace

void add_encode_options(CLI::App& command, EncodeOptions& options) {
  add_position_quality(command, options.quality);
  command.add_flag("--lossless", options.lossless,
                   "every bit of the float32 coordinates and of the attributes");
  add_attribute_quality(command, options.attributes);
  add_coders(command, options);
  add_settings(command, options);
  command.parse_complete_callback([&command, &options] {
    for (const char* name : kAttributeOptions)
      if (options.lossless && command.count(name) > 0)
        throw CLI::ValidationError(name, "excluded by --lossless, which keeps attributes exactly");
    options.attributes.is_asked = asks_of_attributes(command);
  });
}

bool asks_of_attributes(const CLI::App& command) {
  return std::ranges::any_of(kAttributeOptions, [&](const char* name) { return command.count(name) > 0; });
}

bool check_named_bounds(const AttributeQuality& quality, const std::string& path, const Mesh& mesh,
                        int& status, const std::string& kept_in) {
  for (const NamedBound& bound : quality.named) {
    const auto has_name = [&](const Attribute& attribute) { return attribute.name == bound.name; };
    const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(), has_name);
    if (found != mesh.attributes.end() && found->kind == AttributeKind::kGeneric) continue;
    std::string wrong;
    if (found != mesh.attributes.end()) {
      wrong = bound.name + " is " + kind_text(found->kind) + ", for which there is an option of its own";
    } else {
      wrong = path + " has no attribute " + bound.name + "; it has";
      for (const Attribute& attribute : mesh.attributes)
        wrong += (&attribute == mesh.attributes.data() ? ": " : " ") + attribute.name;
      if (mesh.attributes.empty()) wrong += " none";
    }
    if (kept_in.empty())
      print_error(bound.is_mean ? "--attribute-rms" : "--attribute-error", wrong);
    else
      print_error(kept_in, wrong + "; other bounds on attributes replace those kept");
    status = kUsage;
    return false;
  }
  return true;
}

void add_part_quality(CLI::App& command, PartQuality& quality) {
  add_bounds(command, quality.bounds);
  add_attribute_quality(command, quality.attributes);
  add_search(command, quality.geometry, quality.effort);
}

}  // namespace deltamesh::cli
