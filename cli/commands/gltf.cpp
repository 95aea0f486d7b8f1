// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/gltf.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "deltamesh/io.h"
#include "encode_options.h"
#include "mesh_files.h"
#include "report/attributes.h"
#include "report/console.h"
#include "report/progress.h"

namespace deltamesh::cli {
namespace {

struct GltfArguments {
  std::string in;
  std::string out;
  GltfPackOptions pack;
  bool json = false;
};

std::string semantic_text(const GltfAttributeReport& attribute) {
  return attribute.semantic + (attribute.morph ? " of morph targets" : "");
}

nlohmann::ordered_json attributes_object(const GltfReport& report) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const GltfAttributeReport& attribute : report.attributes) {
    nlohmann::ordered_json entry;
    entry["semantic"] = attribute.semantic;
    entry["morph"] = attribute.morph;
    entry["kind"] = kind_text(attribute.kind);
    entry["bytes"] = attribute.bytes;
    entry["max_error"] = attribute.error;
    if (attribute.rms > 0) entry["rms"] = attribute.rms;
    entry["unit"] = unit_name(attribute.kind);
    list.push_back(entry);
  }
  return list;
}

/// What is no mesh, and what makes it smaller. Those tools do not know the extension.
void add_others(Summary& summary, const GltfReport& report, bool packed) {
  const auto add = [&](const char* what, std::uint64_t bytes, const char* advice) {
    if (bytes == 0) return;
    const double share = 100.0 * static_cast<double>(bytes) / static_cast<double>(report.output_bytes);
    summary.add(what, counted(bytes, "byte", "bytes") + ", " + brief(std::round(share)) + " % of the asset" +
                          (packed ? advice : ""));
  };
  add("  animations", report.animation_bytes,
      "; smaller by \"gltf-transform resample\" or gltfpack, before packing");
  add("  textures", report.image_bytes,
      "; smaller by \"gltf-transform webp\" or \"gltf-transform etc1s\", before packing");
}

/// `converted`: "compressed" or "decompressed".
void print_summary(const GltfArguments& arguments, const char* converted, const GltfReport& report) {
  Summary summary(arguments.in + " -> " + arguments.out);
  summary.add("primitives", grouped(report.converted) + " of " + grouped(report.primitives) + ' ' +
                                converted + ", " + counted(report.streams, "stream", "streams"));
  const std::uint64_t left = report.primitives - report.converted;
  const bool packs = converted == std::string("compressed");
  if (left > 0 && packs)
    summary.add("left as is", grouped(report.not_triangles) + " without a triangle list, " +
                                  grouped(report.not_float_positions) + " with quantised positions, " +
                                  grouped(report.otherwise_compressed) + " otherwise compressed, " +
                                  grouped(report.not_smaller) + " that packing would not make smaller");
  summary.add("vertices", grouped(report.vertices));
  summary.add("triangles", grouped(report.triangles));
  if (report.unreferenced_vertices > 0)
    summary.add("dropped",
                counted(report.unreferenced_vertices, "vertex", "vertices") + " that no face uses");
  if (report.degenerate_triangles > 0)
    summary.add("dropped", counted(report.degenerate_triangles, "triangle", "triangles") +
                               " with two corners at one place");
  if (report.welded_vertices > 0)
    summary.add("dropped", counted(report.welded_vertices, "vertex", "vertices") + " equal to another");
  summary.add("streams", counted(report.stream_bytes, "byte", "bytes"));
  for (const GltfAttributeReport& attribute : report.attributes)
    summary.add("  " + semantic_text(attribute),
                counted(attribute.bytes, "byte", "bytes") + ", " +
                    kept_text(attribute.kind, attribute.error, attribute.rms));
  add_dropped_lengths(summary, report.dropped_lengths);
  if (report.max_error > 0)
    summary.add("max error", brief(report.max_error) + " (" + brief(report.max_error_percent) +
                                 " % of the diagonal of its mesh)");
  summary.add("asset", grouped(report.input_bytes) + " -> " + counted(report.output_bytes, "byte", "bytes"));
  add_others(summary, report, packs);
  if (report.copied_files > 0)
    summary.add("copied", counted(report.copied_files, "file", "files") + " that the asset names");
  if (report.missing_files > 0)
    summary.add("missing", counted(report.missing_files, "file", "files") + " that the asset names");
  summary.print();
}

/// `packed`: with the figures that only packing has.
void print_object(const GltfReport& report, bool packed) {
  nlohmann::ordered_json object;
  object["primitives"] = report.primitives;
  object["converted"] = report.converted;
  object["streams"] = report.streams;
  object["not_triangles"] = report.not_triangles;
  object["not_float_positions"] = report.not_float_positions;
  object["otherwise_compressed"] = report.otherwise_compressed;
  object["not_smaller"] = report.not_smaller;
  object["vertices"] = report.vertices;
  object["triangles"] = report.triangles;
  object["unreferenced_vertices"] = report.unreferenced_vertices;
  object["degenerate_triangles"] = report.degenerate_triangles;
  object["welded_vertices"] = report.welded_vertices;
  object["stream_bytes"] = report.stream_bytes;
  object["input_bytes"] = report.input_bytes;
  object["output_bytes"] = report.output_bytes;
  object["animation_bytes"] = report.animation_bytes;
  object["image_bytes"] = report.image_bytes;
  object["copied_files"] = report.copied_files;
  object["missing_files"] = report.missing_files;
  if (packed) {
    object["dropped_lengths"] = report.dropped_lengths;
    object["max_error"] = report.max_error;
    object["max_error_percent"] = report.max_error_percent;
    object["attributes"] = attributes_object(report);
  }
  print_json(object);
}

Result<GltfReport> pack_showing_progress(const GltfArguments& arguments) {
  Progress progress("packing");
  GltfPackOptions options = arguments.pack;
  options.encode.progress = progress.callback();
  return pack_gltf_file(arguments.in, arguments.out, options);
}

Result<GltfReport> unpack_showing_progress(const GltfArguments& arguments) {
  Progress progress("unpacking");
  return unpack_gltf_file(arguments.in, arguments.out, {.limits = {}, .progress = progress.callback()});
}

int report_result(const GltfArguments& arguments, const char* converted, const Result<GltfReport>& report) {
  if (report) {
    if (arguments.json)
      print_object(*report, converted == std::string("compressed"));
    else
      print_summary(arguments, converted, *report);
    return kOk;
  }
  const Error& error = report.error();
  return fail(error.code == ErrorCode::kFileWrite ? arguments.out : arguments.in, error);
}

/// Both are assets, and two of them.
bool check_paths(const GltfArguments& arguments, int& status) {
  for (const std::string& path : {arguments.in, arguments.out}) {
    const Result<FileFormat> format = format_of_path(path);
    if (format && (*format == FileFormat::kGlb || *format == FileFormat::kGltf)) continue;
    print_error(path, "the name of an asset ends in .glb or .gltf");
    status = kUsage;
    return false;
  }
  return check_keeps_input(arguments.in, arguments.out, status);
}

/// A bound on a name that no primitive has is most likely a slip.
void note_unused_bounds(const GltfArguments& arguments, const GltfReport& report) {
  for (const NamedBound& bound : arguments.pack.encode.attributes.named) {
    const auto has_name = [&](const GltfAttributeReport& attribute) {
      return attribute.semantic == bound.name;
    };
    if (std::none_of(report.attributes.begin(), report.attributes.end(), has_name))
      print_error(bound.is_mean ? "--attribute-rms" : "--attribute-error",
                  "note: no compressed primitive has " + bound.name);
  }
}

int run_pack(const GltfArguments& arguments) {
  int status = kOk;
  if (!check_paths(arguments, status)) return status;
  if (const Result<void> valid = validate(arguments.pack.encode); !valid)
    return fail("gltf pack", valid.error());
  const Result<GltfReport> report = pack_showing_progress(arguments);
  if (report) note_unused_bounds(arguments, *report);
  if (report && report->converted == 0 && report->not_smaller > 0)
    print_error("gltf pack", "note: packing does not pay for this asset, which stays as it is");
  return report_result(arguments, "compressed", report);
}

int run_unpack(const GltfArguments& arguments) {
  int status = kOk;
  if (!check_paths(arguments, status)) return status;
  return report_result(arguments, "decompressed", unpack_showing_progress(arguments));
}

void add_paths(CLI::App& command, GltfArguments& arguments) {
  command.add_option("IN", arguments.in, "asset, .glb or .gltf")->required();
  command
      .add_option("OUT", arguments.out,
                  "asset to write, .glb or .gltf (with a .bin beside it); images and the like are copied to "
                  "its folder")
      ->required();
  command.add_flag("--json", arguments.json, "print one JSON object to standard output");
}

}  // namespace

void add_gltf_command(CLI::App& app, int& status) {
  CLI::App* gltf = app.add_subcommand("gltf", "Compress the meshes inside glTF assets, or decompress them");
  gltf->require_subcommand(1);

  const auto packing = std::make_shared<GltfArguments>();
  CLI::App* pack = gltf->add_subcommand(
      "pack", "Compress every triangle mesh; materials, nodes, animations and the rest stay");
  add_paths(*pack, *packing);
  pack->add_flag("--fallback", packing->pack.fallback,
                 "keep plain data too, so that viewers without the extension can show the asset");
  add_encode_options(*pack, packing->pack.encode);
  pack->footer(
      "Without options no vertex is off by more than 0.02 % of the diagonal of its mesh or 4 % of the mean\n"
      "edge, whichever is less, and attributes keep the errors above. Colours of photographs are\n"
      "kept to 41 dB of PSNR, labels exactly.\n\n"
      "Examples:\n"
      "  deltamesh gltf pack duck.glb duck_packed.glb\n"
      "  deltamesh gltf pack duck.glb duck_for_all.glb --fallback\n"
      "  deltamesh gltf pack helmet.glb helmet_packed.glb --max-error 0.01% --normal-error 1\n");
  pack->callback([packing, &status] { status = run_pack(*packing); });

  const auto unpacking = std::make_shared<GltfArguments>();
  CLI::App* unpack = gltf->add_subcommand("unpack", "Turn a packed asset into a plain one");
  add_paths(*unpack, *unpacking);
  unpack->footer("Example:\n  deltamesh gltf unpack duck_packed.glb duck.glb\n");
  unpack->callback([unpacking, &status] { status = run_unpack(*unpacking); });
}

}  // namespace deltamesh::cli
