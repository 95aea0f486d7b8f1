// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/compare.h"

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "deltamesh/io.h"
#include "mesh_files.h"
#include "report/attributes.h"
#include "report/console.h"
#include "report/heatmap.h"
#include "report/losses.h"
#include "report/progress.h"
#include "report/stream.h"
#include "stored/vertex_order.h"

namespace deltamesh::cli {
namespace {

struct CompareArguments {
  std::string a;
  std::string b;
  std::string order;
  std::string heatmap;
  std::string color_heatmap;
  bool json = false;
  FileOptions files;
};

/// Of A and B.
using Losses = std::array<ReadReport, 2>;

std::string attributes_headline(const Comparison& result) {
  return result.matched_faces > 0 || result.corresponding
             ? "at the corners of " + counted(result.matched_faces, "face", "faces")
             : "not measured, for no faces correspond";
}

/// Errors at which the colours of heat maps saturate.
struct HeatmapScales {
  float positions;  ///< model units
  float colors;     ///< CIEDE2000
};

void print_summary(const CompareArguments& arguments, const Losses& losses, const Comparison& result,
                   HeatmapScales scales) {
  Summary summary(arguments.a + " and " + arguments.b);
  if (result.corresponding) {
    summary.add("vertices", std::string("correspond") + (result.reordered ? ", in another order" : "") +
                                "; measured on " + grouped(result.measured_vertices));
    add_errors(summary, result.quality, result.diagonal);
  } else {
    summary.add("vertices", "do not correspond; distances of vertices to the other surface, both ways");
    summary.add("faces", grouped(result.matched_faces) + " in both, " + grouped(result.unmatched_faces_a) +
                             " only in A, " + grouped(result.unmatched_faces_b) + " only in B");
    if (arguments.b.ends_with(".dmsh") && arguments.order.empty())
      summary.add("", "the file of `encode --order-out`, given as --order, pairs the vertices of a stream");
    summary.add("rms", of_diagonal(result.surface_rms, result.diagonal));
    summary.add("max", of_diagonal(result.surface_max, result.diagonal));
  }
  summary.add("normals", brief(result.normal_angle_mean) + " degrees apart on average, " +
                             brief(result.normal_angle_p95) + " at the 95th percentile");
  summary.add("diagonal", brief(result.diagonal));
  if (!result.attributes.empty()) summary.add("attributes", attributes_headline(result));
  add_attributes(summary, result);
  if (!arguments.heatmap.empty())
    summary.add("heat map", arguments.heatmap + ", red is " + of_diagonal(scales.positions, result.diagonal) +
                                " outward, blue inward");
  if (!arguments.color_heatmap.empty())
    summary.add("colour heat map",
                arguments.color_heatmap + ", red is a CIEDE2000 of " + brief(scales.colors));
  for (std::size_t m = 0; m < losses.size(); ++m)
    if (!losses[m].left_out.empty())
      summary.add(m == 0 ? "left out of A" : "left out of B", left_out_text(losses[m]));
  summary.print();
}

void print_object(const CompareArguments& arguments, const Losses& losses, const Comparison& result,
                  HeatmapScales scales) {
  nlohmann::ordered_json object;
  const nlohmann::ordered_json none = nullptr;
  const bool pairs = result.corresponding;
  const PaperQuality paper = paper_form(result.quality, result.measured_vertices, result.diagonal);
  const auto where = [&none](bool applies, double value) {
    return applies ? nlohmann::ordered_json(value) : none;
  };
  object["corresponding"] = pairs;
  object["reordered"] = result.reordered;
  object["matched_faces"] = result.matched_faces;
  object["unmatched_faces_a"] = result.unmatched_faces_a;
  object["unmatched_faces_b"] = result.unmatched_faces_b;
  object["vde_rms"] = where(pairs, result.quality.vde_rms);
  object["lfe_rms"] = where(pairs, result.quality.lfe_rms);
  object["max_error"] = where(pairs, result.quality.max_error);
  object["vde_paper"] = where(pairs, paper.vde);
  object["lfe_paper"] = where(pairs, paper.lfe);
  object["surface_rms"] = where(!pairs, result.surface_rms);
  object["surface_max"] = where(!pairs, result.surface_max);
  object["normal_angle_mean"] = result.normal_angle_mean;
  object["normal_angle_p95"] = result.normal_angle_p95;
  object["diagonal"] = result.diagonal;
  object["measured_vertices"] = pairs ? nlohmann::ordered_json(result.measured_vertices) : none;
  object["attributes"] = attributes_object(result);
  object["left_out_a"] = left_out_array(losses[0]);
  object["left_out_b"] = left_out_array(losses[1]);
  if (!arguments.heatmap.empty()) object["heatmap_scale"] = scales.positions;
  if (!arguments.color_heatmap.empty()) object["color_heatmap_scale"] = scales.colors;
  print_json(object);
}

/// An error of compare() can be due to the order file or to either mesh.
int fail_comparison(const CompareArguments& arguments, const Error& error) {
  if (error.code != ErrorCode::kInvalidArgument) return fail(arguments.a + ", " + arguments.b, error);
  fail(arguments.order.empty() ? arguments.b : arguments.order, error);
  return kBadInput;
}

Result<Comparison> compare_showing_progress(const Imported& a, const Imported& b,
                                            const std::vector<std::uint32_t>& order) {
  const Progress progress("comparing");
  return compare(a.mesh, b.mesh, order, {.a = a.roundings, .b = b.roundings});
}

/// Heat maps are mesh files, and other ones than the meshes.
bool check_heatmaps(const CompareArguments& arguments, int& status) {
  for (const std::string& map : {arguments.heatmap, arguments.color_heatmap}) {
    if (map.empty()) continue;
    if (!check_mesh_suffix(map, status)) return false;
    if (*format_of_path(map) == FileFormat::kStl) {
      print_error(map, "STL has no colours, which a heat map is made of");
      status = kUsage;
      return false;
    }
    for (const std::string& mesh : {arguments.a, arguments.b}) {
      if (!names_same_file(map, mesh)) continue;
      print_error(map, "the heat map would replace a mesh that it compares");
      status = kUsage;
      return false;
    }
  }
  if (!names_same_file(arguments.heatmap, arguments.color_heatmap)) return true;
  print_error(arguments.heatmap, "--heatmap and --color-heatmap are one file");
  status = kUsage;
  return false;
}

int save_heatmaps(const CompareArguments& arguments, const Mesh& mesh, const Comparison& result,
                  HeatmapScales scales) {
  int status = kOk;
  if (!arguments.heatmap.empty())
    status = save_mesh(arguments.heatmap, heatmap(mesh, result.signed_error, scales.positions));
  if (status != kOk || arguments.color_heatmap.empty()) return status;
  if (result.color_difference.empty()) {
    print_error(arguments.color_heatmap, "the meshes have no colours to compare");
    return kUsage;
  }
  return save_mesh(arguments.color_heatmap, heatmap(mesh, result.color_difference, scales.colors));
}

int run_compare(const CompareArguments& arguments) {
  int status = kOk;
  if (!check_heatmaps(arguments, status)) return status;
  const std::optional<Imported> a = load_mesh_or_stream(arguments.a, status, arguments.files);
  if (!a) return status;
  const std::optional<Imported> b = load_mesh_or_stream(arguments.b, status, arguments.files);
  if (!b) return status;
  const std::vector<std::string> outputs{arguments.heatmap, arguments.color_heatmap};
  if (!check_keeps_files(arguments.a, a->report, outputs, status) ||
      !check_keeps_files(arguments.b, b->report, outputs, status))
    return status;
  std::vector<std::uint32_t> order;
  if (!arguments.order.empty()) order = load_order(arguments.order, a->file_vertices, status);
  if (status != kOk) return status;

  const Result<Comparison> result = compare_showing_progress(*a, *b, order);
  if (!result) return fail_comparison(arguments, result.error());
  const HeatmapScales scales{heatmap_scale(result->signed_error), heatmap_scale(result->color_difference)};
  status = save_heatmaps(arguments, b->mesh, *result, scales);
  if (status != kOk) return status;
  const Losses losses{a->report, b->report};
  if (arguments.json)
    print_object(arguments, losses, *result, scales);
  else
    print_summary(arguments, losses, *result, scales);
  if (order.empty() || result->corresponding) return kOk;
  print_error(arguments.b, "its triangles are not those of " + arguments.a + " under the given order");
  return kBadStream;
}

}  // namespace

void add_compare_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "Measure how far mesh B is from mesh A");
  command->add_option("A", arguments->a, std::string("original: ") + kMeshSuffixes + " .dmsh")->required();
  command->add_option("B", arguments->b, "approximation, the same kinds")->required();
  command->add_option("--order", arguments->order,
                      "file of `encode --order-out`: the vertex of A for every vertex of B");
  command->add_option("--heatmap", arguments->heatmap,
                      "write B coloured by signed error: green none, red outward, blue inward");
  command->add_option("--color-heatmap", arguments->color_heatmap,
                      "write B coloured by the difference of its colours, CIEDE2000: green none, red much");
  add_file_options(*command, arguments->files, true);
  command->add_flag("--json", arguments->json, "print one JSON object to standard output");
  command->footer(
      "Vertices correspond where both meshes have the same triangles. They may come in another order: faces "
      "are\n"
      "found by place and neighbours, or --order says which vertex is which. Then the visual (VDE),\n"
      "low-frequency (LFE) and largest vertex errors are measured, otherwise the distances of the vertices "
      "of\n"
      "both meshes to the surface of the other. Attributes are compared at the corners of the faces that "
      "were\n"
      "found.\n\n"
      "Examples:\n"
      "  deltamesh compare bunny.ply bunny.dmsh\n"
      "  deltamesh encode bunny.ply bunny.dmsh --order-out bunny.order\n"
      "  deltamesh compare bunny.ply bunny.dmsh --order bunny.order --heatmap errors.ply\n"
      "  deltamesh compare helmet.glb helmet_unpacked.glb\n");
  command->callback([arguments, &status] { status = run_compare(*arguments); });
}

}  // namespace deltamesh::cli
