// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/encode.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "commands/commands.h"
#include "deltamesh/io.h"
#include "encode_options.h"
#include "mesh_files.h"
#include "report/attributes.h"
#include "report/console.h"
#include "report/losses.h"
#include "report/progress.h"
#include "report/stream.h"
#include "stored/vertex_order.h"

namespace deltamesh::cli {
namespace {

struct EncodeArguments {
  std::string in;
  std::string out;
  std::string order_out;
  bool json = false;
  FileOptions files;
  EncodeOptions options;
};

/// Names of the attributes that stay exact because they have no bound, each after a blank.
std::string exact_names(const Mesh& mesh, const AttributeQuality& quality) {
  std::string names;
  for (const Attribute& attribute : mesh.attributes) {
    const auto is_its = [&](const NamedBound& bound) { return bound.name == attribute.name; };
    if (attribute.kind == AttributeKind::kGeneric && std::ranges::none_of(quality.named, is_its))
      names += ' ' + attribute.name;
  }
  return names;
}

void print_summary(const EncodeArguments& arguments, const ReadReport& read, const EncodeReport& report,
                   double seconds) {
  const StreamInfo& stream = report.stream;
  Summary summary(arguments.in + " -> " + arguments.out);
  std::string vertices = grouped(stream.vertices);
  if (report.unreferenced_vertices > 0)
    vertices += " (" +
                unreferenced_text(report.unreferenced_vertices,
                                  arguments.options.keep_unreferenced ? "kept" : "dropped") +
                ')';
  summary.add("vertices", vertices);
  std::string triangles = grouped(stream.triangles);
  if (read.polygons > 0) triangles += " (" + counted(read.polygons, "polygon", "polygons") + " split)";
  summary.add("triangles", triangles);
  if (!read.left_out.empty()) summary.add("left out", left_out_text(read));
  if (read.position_error > 0 && arguments.options.lossless)
    summary.add("not lossless", "coordinates became float32, off by up to " + brief(read.position_error));
  summary.add("components", grouped(stream.components));
  add_extent(summary, stream);
  add_sizes(summary, stream);
  add_attributes(summary, stream, report.labels);
  if (read.uv_scale > 1)
    summary.add("textures", "stretched " + brief(read.uv_scale) +
                                " times by KHR_texture_transform, for which the bound is divided");
  add_dropped_lengths(summary, report.dropped_lengths);
  add_settings(summary, stream);
  add_errors(summary, stream.quality, stream.extent);
  summary.add("time", brief(seconds) + " s");
  summary.print(report_stream(arguments.out));
}

void print_object(const EncodeArguments& arguments, const ReadReport& read, const EncodeReport& report,
                  double seconds) {
  nlohmann::ordered_json object;
  object["input_vertices"] = report.input_vertices;
  object["unreferenced_vertices"] = report.unreferenced_vertices;
  object["dropped_lengths"] = report.dropped_lengths;
  object["labels"] = report.labels;
  object["left_out"] = left_out_array(read);
  object["position_error"] = read.position_error;
  object["uv_scale"] = read.uv_scale;
  add_stream(object, report.stream);
  object["encode_seconds"] = seconds;
  print_json(object, report_stream(arguments.out));
}

Result<Encoded> encode_showing_progress(const Mesh& mesh, EncodeOptions options) {
  Progress progress("encoding");
  options.progress = progress.callback();
  return encode(mesh, options);
}

/// A stream or an order under a mesh's suffix is a slip: written, it would most often replace the mesh.
bool check_outputs(const EncodeArguments& arguments, int& status) {
  if (is_standard(arguments.order_out)) {
    print_error("--order-out", "needs the name of a file");
    status = kUsage;
    return false;
  }
  for (const std::string& path : {arguments.out, arguments.order_out}) {
    if (!check_keeps_input(arguments.in, path, status)) return false;
    if (!format_of_path(path)) continue;
    print_error(path, "this suffix is a mesh file's; `encode` writes a stream, .dmsh");
    status = kUsage;
    return false;
  }
  if (!names_same_file(arguments.out, arguments.order_out)) return true;
  print_error(arguments.out, "OUT and --order-out are one file");
  status = kUsage;
  return false;
}

/// The stream and the order, both or none; returns the exit code.
int write_outputs(const EncodeArguments& arguments, const Encoded& encoded,
                  const std::vector<std::uint32_t>& file_vertices) {
  if (is_standard(arguments.out))
    if (const Result<void> written = write_output(arguments.out, encoded.bytes); !written)
      return fail(arguments.out, written.error());
  const std::vector<std::byte> order = order_bytes(encoded.order, file_vertices);
  std::vector<NewFile> files;
  if (!is_standard(arguments.out)) files.push_back({arguments.out, encoded.bytes});
  if (!arguments.order_out.empty()) files.push_back({arguments.order_out, order});
  const Result<void> written = write_files(files);
  return written ? kOk : fail(files[written.error().where].path, written.error());
}

int run_encode(const EncodeArguments& arguments) {
  if (const Result<void> valid = validate(arguments.options); !valid) return fail("encode", valid.error());
  int status = kOk;
  if (!check_outputs(arguments, status)) return status;
  std::optional<Imported> imported =
      load_faces(arguments.in, status, arguments.files, arguments.options.keep_unreferenced);
  if (imported && arguments.options.keep_unreferenced)
    imported->report.position_error =
        std::max(imported->report.position_error, imported->report.unused_position_error);
  if (!imported || !check_named_bounds(arguments.options.attributes, arguments.in, imported->mesh, status) ||
      !check_keeps_files(arguments.in, imported->report, {arguments.out, arguments.order_out}, status))
    return status;

  if (arguments.options.lossless && arguments.files.strict && imported->report.position_error > 0) {
    print_error(arguments.in,
                "coordinates are no float32 numbers, which --lossless with --strict forbids: off by up to " +
                    brief(imported->report.position_error));
    return kBadInput;
  }
  EncodeOptions options = arguments.options;
  options.source_error = imported->report.position_error;
  options.attributes.uv_error /= imported->report.uv_scale;
  const auto start = std::chrono::steady_clock::now();
  const Result<Encoded> encoded = encode_showing_progress(imported->mesh, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (!encoded) {
    const std::string exact =
        options.quality.target_bytes ? exact_names(imported->mesh, options.attributes) : std::string();
    const ExitCode code = fail_coding(arguments.in, encoded.error());
    if (code == kUnmetRequest && !exact.empty())
      print_error("--target-bytes", "kept exact because --attribute-error names no bound:" + exact);
    return code;
  }
  if (arguments.files.strict && encoded->report.dropped_lengths > 0) {
    print_error(arguments.in,
                "left out, which --strict forbids: " + lengths_text(encoded->report.dropped_lengths));
    return kBadInput;
  }

  if (const int code = write_outputs(arguments, *encoded, imported->file_vertices); code != kOk) return code;
  if (arguments.json)
    print_object(arguments, imported->report, encoded->report, elapsed.count());
  else
    print_summary(arguments, imported->report, encoded->report, elapsed.count());
  return kOk;
}

}  // namespace

void add_encode_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<EncodeArguments>();
  CLI::App* command = app.add_subcommand("encode", "Compress a mesh file into a .dmsh stream");
  command
      ->add_option("IN", arguments->in, std::string("mesh file: ") + kMeshSuffixes + "; - is standard input")
      ->required();
  command
      ->add_option("OUT", arguments->out,
                   "stream to write, .dmsh; - is standard output, reports go to standard error then")
      ->required();
  add_file_options(*command, arguments->files, true);
  add_encode_options(*command, arguments->options);
  command->add_option(
      "--order-out", arguments->order_out,
      "write the number of the input vertex, from 0 on, of every decoded vertex, as little-endian uint32");
  command->add_flag("--json", arguments->json, "print one JSON object to standard output");
  command->footer(
      "Without options no vertex is off by more than 0.02 % of the diagonal of its mesh or 4 % of the mean\n"
      "edge, whichever is less, and attributes keep the errors above. Colours of photographs are\n"
      "kept to 41 dB of PSNR, labels exactly.\n\n"
      "Examples:\n"
      "  deltamesh encode bunny.ply bunny.dmsh\n"
      "  deltamesh encode map.ply map.dmsh --max-error 0.02 --color-psnr 38\n"
      "  deltamesh encode map.ply map.dmsh --target-bytes 100000\n"
      "  deltamesh encode helmet.glb helmet.dmsh --max-error 0.01% --normal-error 1 --uv-error 1/2048\n"
      "  deltamesh encode scan.ply scan.dmsh --vde 0.01% --lfe 0.1% --attribute-error intensity=0.5\n"
      "  deltamesh encode bunny.ply bunny.dmsh --bits 6 --json > figures.json\n");
  command->callback([arguments, &status] { status = run_encode(*arguments); });
}

}  // namespace deltamesh::cli
