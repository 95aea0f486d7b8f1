// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "deltamesh/stream_info.h"
#include "map_files.h"
#include "mesh_files.h"
#include "report/attributes.h"
#include "report/console.h"
#include "report/stream.h"

namespace deltamesh::cli {
namespace {

struct InfoArguments {
  std::string file;
  bool json = false;
};

std::string format_text(const StreamInfo& info) {
  std::string text = std::to_string(info.format_major) + '.' + std::to_string(info.format_minor);
  if (info.format_draft != 0) text += " draft " + std::to_string(info.format_draft);
  return text;
}

void print_chunk_row(const char* tag, const char* codec, const std::string& offset, const std::string& coded,
                     const std::string& decoded) {
  char row[160];
  std::snprintf(row, sizeof row, "  %-6s %-7s %14s %14s %14s\n", tag, codec, offset.c_str(), coded.c_str(),
                decoded.c_str());
  std::cout << row;
}

void print_chunks(const StreamInfo& info) {
  print_chunk_row("chunk", "codec", "offset", "bytes", "decoded");
  for (const ChunkInfo& chunk : info.chunks)
    print_chunk_row(chunk.tag.data(), chunk.codec, grouped(chunk.offset), grouped(chunk.coded_bytes),
                    grouped(chunk.decoded_bytes));
}

void print_summary(const InfoArguments& arguments, const StreamInfo& info) {
  Summary summary(arguments.file + ": deltamesh stream, format " + format_text(info));
  summary.add("vertices", grouped(info.vertices) + " (" +
                              counted(info.geometric_vertices, "distinct position)", "distinct positions)"));
  summary.add("triangles", grouped(info.triangles));
  summary.add("components", grouped(info.components));
  const std::array<float, 3> sides{info.box_max[0] - info.box_min[0], info.box_max[1] - info.box_min[1],
                                   info.box_max[2] - info.box_min[2]};
  summary.add("box",
              brief_list(sides, " x ") + (info.geometry == "grid" ? ", whole cubes of the grid"
                                                                  : ", diagonal " + brief(info.diagonal)));
  add_extent(summary, info);
  summary.add("origin", brief_list(info.origin, " "));
  summary.add("checksums", "all match");  // inspect() fails where one does not
  summary.add("order", info.keeps_order ? "the input's" : "the coder's own");
  add_settings(summary, info);
  add_errors(summary, info.quality, info.extent);
  add_sizes(summary, info);
  add_attributes(summary, info);
  summary.print();
}

void print_object(const StreamInfo& info) {
  nlohmann::ordered_json object;
  object["format_version"] = std::to_string(info.format_major) + '.' + std::to_string(info.format_minor);
  object["format_draft"] = info.format_draft;
  add_stream(object, info);
  object["keeps_order"] = info.keeps_order;
  object["origin"] = info.origin;
  object["box_min"] = info.box_min;
  object["box_max"] = info.box_max;
  object["chunks"] = nlohmann::ordered_json::array();
  for (const ChunkInfo& chunk : info.chunks) {
    nlohmann::ordered_json entry;
    entry["tag"] = chunk.tag.data();
    entry["codec"] = chunk.codec;
    entry["offset"] = chunk.offset;
    entry["coded_bytes"] = chunk.coded_bytes;
    entry["decoded_bytes"] = chunk.decoded_bytes;
    object["chunks"].push_back(entry);
  }
  print_json(object);
}

int run_info(const InfoArguments& arguments) {
  if (refuse_map(arguments.file, "map info")) return kBadInput;
  const Result<std::vector<std::byte>> bytes = read_input(arguments.file);
  if (!bytes) return fail(arguments.file, bytes.error());
  const Result<StreamInfo> info = inspect(*bytes);
  if (!info) return fail(arguments.file, info.error());
  if (arguments.json) {
    print_object(*info);
    return kOk;
  }
  print_summary(arguments, *info);
  print_chunks(*info);
  return kOk;
}

}  // namespace

void add_info_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command =
      app.add_subcommand("info", "Tell what a stream holds: counts, sizes, achieved errors, chunks");
  command->add_option("FILE", arguments->file, "stream, .dmsh; - is standard input")->required();
  command->add_flag("--json", arguments->json, "print one JSON object to standard output");
  command->footer("Headers and the checksum are checked, nothing is decoded; `verify` checks everything.\n");
  command->callback([arguments, &status] { status = run_info(*arguments); });
}

}  // namespace deltamesh::cli
