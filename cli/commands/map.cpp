// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/map.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "commands/commands.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/folder.h"
#include "encode_options.h"
#include "map_bounds_file.h"
#include "mesh_files.h"
#include "option_numbers.h"
#include "report/console.h"
#include "report/losses.h"
#include "report/progress.h"

namespace deltamesh::cli {
namespace {

struct Splitting {
  std::string in;
  std::string folder;
  MapSettings settings;
  FileOptions files;
  bool json = false;
};

struct Folders {
  std::string first;
  std::string second;
  std::uint8_t level = 0;
  FileOptions files;
  bool json = false;
};

bool is_map(const std::string& folder) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(folder) / "map.dmm", ignored);
}

std::optional<MapManifest> load_manifest(const std::string& folder, int& status) {
  auto manifest = load_map(folder);
  if (manifest) return *std::move(manifest);
  status = fail((std::filesystem::path(folder) / "map.dmm").string(), manifest.error());
  return std::nullopt;
}

std::optional<MapState> load_state(const std::string& folder, int& status) {
  auto manifest = load_manifest(folder, status);
  if (!manifest) return std::nullopt;
  MapState state{.manifest = *std::move(manifest), .bounds = load_bounds(folder)};
  for (const PartEntry& entry : state.manifest.entries) {
    auto octets = load_part(folder, entry);
    if (!octets) {
      status = fail(folder + ", part of " + key_text(entry.key), octets.error());
      return std::nullopt;
    }
    state.octets.push_back(*std::move(octets));
  }
  return state;
}

int run_split(const Splitting& splitting) {
  if (const Result<void> valid = validate(splitting.settings); !valid)
    return fail("map split", valid.error());
  int status = kOk;
  auto imported = load_faces(splitting.in, status, splitting.files);
  if (!imported) return status;
  imported->report.leave_out(LeftOutKind::kNames, "groups", imported->mesh.group_names.size());
  std::optional<MapState> before;
  if (is_map(splitting.folder)) {
    before = load_state(splitting.folder, status);
    if (!before) return status;
  }
  MapSettings settings = splitting.settings;
  settings.quality.attributes.uv_error /= imported->report.uv_scale;
  const auto encode = [&] {
    const Progress progress("encoding");
    return encode_map(imported->mesh, settings, before ? &*before : nullptr);
  };
  const Result<MapState> state = encode();
  if (!state) return fail_coding(splitting.in, state.error());
  std::vector<NewPart> parts;
  for (std::size_t i = 0; i < state->octets.size(); ++i)
    if (const PartEntry& entry = state->manifest.entries[i];
        !before || entry.revision == state->manifest.revision)
      parts.push_back({entry.key, entry.revision, state->octets[i]});
  auto saved = save_map(splitting.folder, state->manifest, parts);
  if (saved) saved = save_bounds(splitting.folder, state->bounds);
  if (!saved) return fail(splitting.folder, saved.error());
  const double rounding =
      imported->report.position_error + rounding_in_map(imported->mesh, state->manifest.description);
  if (splitting.json) {
    auto object = map_object(state->manifest);
    if (state->attributes.color_rms) object["color_rms"] = *state->attributes.color_rms;
    object.update({{"new_parts", parts.size()},
                   {"left_out", left_out_array(imported->report)},
                   {"position_error", rounding},
                   {"uv_scale", imported->report.uv_scale}});
    print_json(object);
  } else {
    print_map(splitting.in + " -> " + splitting.folder, state->manifest, parts.size(),
              state->attributes.color_rms.value_or(0));
    print_rounding(rounding, report_stream({}));
    print_stretch(imported->report.uv_scale, report_stream({}));
    print_left_out(imported->report, report_stream({}));
  }
  return kOk;
}

int run_join(const Folders& folders) {
  int status = kOk;
  if (!check_mesh_suffix(folders.second, status, folders.files)) return status;
  const auto state = load_state(folders.first, status);
  if (!state) return status;
  const Result<Mesh> mesh = decode_map(*state, {}, folders.level);
  if (!mesh) return fail(folders.first, mesh.error());
  return save_mesh(folders.second, *mesh, folders.files);
}

int run_map_info(const Folders& folders) {
  int status = kOk;
  const auto manifest = load_manifest(folders.first, status);
  if (!manifest) return status;
  if (folders.json)
    print_json(map_object(*manifest));
  else
    print_map(folders.first + ": deltamesh map", *manifest);
  return kOk;
}

int run_diff(const Folders& folders) {
  int status = kOk;
  const auto before = load_manifest(folders.first, status);
  if (!before) return status;
  const auto after = load_manifest(folders.second, status);
  if (!after) return status;
  const bool is_same_epoch = before->description == after->description;
  const auto list = map_differences(*before, *after);
  std::uint64_t bytes = 0;
  nlohmann::ordered_json object;
  object["same_description"] = is_same_epoch;
  object["parts"] = nlohmann::ordered_json::array();
  std::string text;
  for (const auto& [kind, entry] : list) {
    const bool is_removed = kind == std::string("removed");
    if (!is_removed) bytes += entry->bytes;
    auto part = key_object(entry->key);
    part["change"] = kind;
    part["bytes"] = is_removed ? 0 : entry->bytes;
    object["parts"].push_back(part);
    text += "  " + std::string(kind) + ": " + key_text(entry->key) +
            (is_removed ? "" : ", " + counted(entry->bytes, "byte", "bytes")) + '\n';
  }
  object["bytes"] = bytes;
  if (folders.json) return print_json(object), kOk;
  Summary summary(folders.first + " -> " + folders.second);
  summary.add("what all parts share", is_same_epoch ? "is the same" : "is not the same");
  summary.add("differences", counted(list.size(), "part", "parts") + ", " + counted(bytes, "byte", "bytes"));
  summary.print();
  std::fputs(text.c_str(), stdout);
  return kOk;
}

void add_split(CLI::App& map, int& status) {
  const auto splitting = std::make_shared<Splitting>();
  CLI::App* command = map.add_subcommand("split", "Make a map of a mesh file, or of a new version of it");
  command->add_option("IN", splitting->in, std::string("mesh file: ") + kMeshSuffixes)->required();
  command
      ->add_option("DIR", splitting->folder,
                   "folder of the map; where it holds one, that is brought up to date")
      ->required();
  command->add_option("--part-edge", splitting->settings.part_edge, "edge of the largest parts, model units")
      ->required();
  command
      ->add_option("--part-triangles", splitting->settings.most_triangles,
                   "parts with more are divided, down to an eighth of the edge")
      ->capture_default_str();
  command
      ->add_option(
          "--levels", splitting->settings.levels,
          "coarser levels above the largest parts, each of cells of twice the edge; with any there are "
          "coarser copies of smaller parts, too")
      ->check(CLI::Range(0, 21))
      ->capture_default_str();
  command->add_option("--map-id", splitting->settings.id, "which map")
      ->check(refuse_negative)
      ->capture_default_str();
  command->add_option("--frame", splitting->settings.frame, "name of the coordinate frame")
      ->capture_default_str();
  add_file_options(*command, splitting->files, true);
  add_part_quality(*command, splitting->settings.quality);
  command->add_flag("--json", splitting->json, "print one JSON object to standard output");
  command->footer(
      "Percentages count in the diagonal of the whole mesh. Parts that stay as they are keep their files.\n\n"
      "Colours of photographs are kept to 41 dB of PSNR, labels exactly.\n\n"
      "Example:\n  deltamesh map split kitchen.ply kitchen.map --part-edge 2 --max-error 0.001\n");
  command->callback([splitting, &status] { status = run_split(*splitting); });
}

void add_folders(CLI::App& map, int& status, const char* name, const char* what, const char* second,
                 const char* about_second, int (*run)(const Folders&)) {
  const auto folders = std::make_shared<Folders>();
  CLI::App* command = map.add_subcommand(name, what);
  command->add_option(second == std::string("NEW") ? "OLD" : "DIR", folders->first, "folder of a map")
      ->required();
  if (*second != '\0') command->add_option(second, folders->second, about_second)->required();
  if (second == std::string("OUT")) {
    command
        ->add_option("--level", folders->level,
                     "make it of parts of this level and above, as coarse as they are (see `map info`)")
        ->check(CLI::Range(0, int{kMostPartLevel}));
    add_file_options(*command, folders->files, false);
  } else {
    command->add_flag("--json", folders->json, "print one JSON object to standard output");
  }
  command->callback([folders, &status, run] { status = run(*folders); });
}

}  // namespace

void add_map_command(CLI::App& app, int& status) {
  CLI::App* map =
      app.add_subcommand("map", "Maps in parts that change one by one and fit together without cracks");
  map->require_subcommand(1);
  add_split(*map, status);
  add_folders(*map, status, "join", "Make one mesh file of a map", "OUT", "mesh file to write", run_join);
  add_folders(*map, status, "diff", "Tell which parts of two maps differ", "NEW", "folder of another one",
              run_diff);
  add_folders(*map, status, "info", "Tell what a map holds; decodes nothing", "", "", run_map_info);
}

}  // namespace deltamesh::cli
