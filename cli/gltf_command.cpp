// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "commands.h"
#include "console.h"
#include "deltamesh/gltf.h"
#include "progress.h"

namespace deltamesh::cli {
namespace {

struct Arguments {
  std::string in;
  std::string out;
  bool fallback = false;
};

/// `converted`: "compressed" or "decompressed".
void print_summary(const Arguments& arguments, const char* converted, const GltfReport& report) {
  Summary summary(arguments.in + " -> " + arguments.out);
  summary.add("primitives", grouped(report.converted) + " of " + grouped(report.primitives) + ' ' +
                                converted + ", " + counted(report.streams, "stream", "streams"));
  const std::uint64_t left = report.primitives - report.converted;
  if (left > 0)
    summary.add("left as is", grouped(report.not_triangles) + " without a triangle list, " +
                                  grouped(report.not_float_positions) + " with quantised positions, " +
                                  grouped(report.otherwise_compressed) + " otherwise compressed");
  summary.add("vertices", grouped(report.vertices));
  summary.add("triangles", grouped(report.triangles));
  if (report.unreferenced_vertices > 0)
    summary.add("dropped",
                counted(report.unreferenced_vertices, "vertex", "vertices") + " that no face uses");
  summary.add("streams", counted(report.stream_bytes, "byte", "bytes"));
  summary.add("asset", grouped(report.input_bytes) + " -> " + counted(report.output_bytes, "byte", "bytes"));
  summary.print();
}

Result<GltfReport> pack_showing_progress(const Arguments& arguments) {
  Progress progress("packing");
  GltfPackOptions options;
  options.fallback = arguments.fallback;
  options.encode.progress = progress.callback();
  return pack_gltf_file(arguments.in, arguments.out, options);
}

Result<GltfReport> unpack_showing_progress(const Arguments& arguments) {
  Progress progress("unpacking");
  return unpack_gltf_file(arguments.in, arguments.out, {.limits = {}, .progress = progress.callback()});
}

int report_result(const Arguments& arguments, const char* converted, const Result<GltfReport>& report) {
  if (report) {
    print_summary(arguments, converted, *report);
    return kOk;
  }
  const Error& error = report.error();
  return fail(error.code == ErrorCode::kFileWrite ? arguments.out : arguments.in, error);
}

void add_paths(CLI::App& command, Arguments& arguments) {
  command.add_option("IN", arguments.in, "asset, .glb or .gltf")->required();
  command.add_option("OUT", arguments.out, "asset to write, .glb or .gltf (with a .bin beside it)")
      ->required();
}

}  // namespace

void add_gltf_command(CLI::App& app, int& status) {
  CLI::App* gltf = app.add_subcommand("gltf", "Compress the meshes inside glTF assets, or decompress them");
  gltf->require_subcommand(1);

  const auto packing = std::make_shared<Arguments>();
  CLI::App* pack = gltf->add_subcommand(
      "pack", "Compress every triangle mesh; materials, nodes, animations and the rest stay");
  add_paths(*pack, *packing);
  pack->add_flag("--fallback", packing->fallback,
                 "keep plain data too, so that viewers without the extension can show the asset");
  pack->footer(
      "Examples:\n"
      "  deltamesh gltf pack duck.glb duck_packed.glb\n"
      "  deltamesh gltf pack duck.glb duck_for_all.glb --fallback\n");
  pack->callback([packing, &status] {
    status = report_result(*packing, "compressed", pack_showing_progress(*packing));
  });

  const auto unpacking = std::make_shared<Arguments>();
  CLI::App* unpack = gltf->add_subcommand("unpack", "Turn a packed asset into a plain one");
  add_paths(*unpack, *unpacking);
  unpack->footer("Example:\n  deltamesh gltf unpack duck_packed.glb duck.glb\n");
  unpack->callback([unpacking, &status] {
    status = report_result(*unpacking, "decompressed", unpack_showing_progress(*unpacking));
  });
}

}  // namespace deltamesh::cli
