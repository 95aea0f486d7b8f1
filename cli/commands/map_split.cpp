// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/map.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/folder.h"
#include "encode_options.h"
#include "map_files.h"
#include "mesh_files.h"
#include "option_numbers.h"
#include "report/console.h"
#include "report/losses.h"
#include "report/map.h"
#include "report/progress.h"
#include "stored/map_bounds.h"
#include "stored/map_lock.h"

namespace deltamesh::cli {
namespace {

struct Splitting {
  std::string in;
  std::string folder;
  MapSettings settings;
  AskedName name;
  std::optional<std::uint32_t> most_triangles;
  std::optional<std::uint8_t> levels;
  FileOptions files;
  bool asks_of_attributes = false;
  bool json = false;
};

/// What the folder holds already; empty where that is no map.
struct Before {
  std::optional<MapState> state;
  MapBounds bounds;
};

std::optional<Before> load_before(const Splitting& splitting, int& status) {
  const std::string& folder = splitting.folder;
  Before before;
  if (!is_map(folder)) return before;
  auto manifest = load_manifest(folder, status);
  const AskedBounds asked{.of_positions = !splitting.settings.quality.bounds.empty(),
                          .of_attributes = splitting.asks_of_attributes};
  if (!manifest || !load_bounds(folder, *manifest, asked, before.bounds, status)) return std::nullopt;
  before.state.emplace(MapState{
      .manifest = *std::move(manifest), .asked = before.bounds.asked, .bounds = before.bounds.bounds});
  return before;
}

MapSettings settings_for(const Splitting& splitting, const Before& before) {
  MapSettings settings = splitting.settings;
  const MapParts parts = before.bounds.parts.value_or(MapParts{});
  settings.most_triangles = splitting.most_triangles.value_or(parts.most_triangles);
  settings.levels = splitting.levels.value_or(parts.levels);
  splitting.name.set_in(settings, before.state ? &before.state->manifest.description : nullptr);
  return settings;
}

int run_split(const Splitting& splitting) {
  if (const Result<void> valid = validate(settings_for(splitting, {})); !valid)
    return fail("map split", valid.error());
  int status = kOk;
  if (!check_is_outside(splitting.folder + "/parts", splitting.in, status)) return status;
  auto imported = load_faces(splitting.in, status, splitting.files);
  if (!imported || !check_are_outside(splitting.folder + "/parts", splitting.in, imported->report, status) ||
      !check_keeps_files(splitting.in, imported->report,
                         {splitting.folder + "/map.dmm", splitting.folder + "/bounds.json"}, status))
    return status;
  imported->report.leave_out(LeftOutKind::kNames, "groups", imported->mesh.group_names.size());
  const auto lock = MapLock::take(splitting.folder, status);
  if (!lock) return status;
  const auto known = load_before(splitting, status);
  if (!known) return status;
  const std::optional<MapState>& before = known->state;
  MapSettings settings = settings_for(splitting, *known);
  MapBounds bounds{.parts = MapParts{settings.most_triangles, settings.levels}};
  if (splitting.asks_of_attributes) bounds.attributes = settings.quality.attributes;
  if (!splitting.asks_of_attributes) bounds.attributes = known->bounds.attributes;
  if (bounds.attributes) settings.quality.attributes = *bounds.attributes;
  if (!check_named_bounds(settings.quality.attributes, splitting.in, imported->mesh, status,
                          splitting.asks_of_attributes ? "" : splitting.folder + "/bounds.json"))
    return status;
  settings.quality.attributes.uv_error /= imported->report.uv_scale;
  const auto encode = [&] {
    const Progress progress("encoding");
    return encode_map(imported->mesh, settings, before ? &*before : nullptr);
  };
  const Result<MapState> state = encode();
  if (!state) return fail_coding(splitting.in, state.error());
  bounds.asked = state->asked;
  bounds.bounds = state->bounds;
  MapUpdate update{
      .keeps_bounds = before && !before->bounds.empty() && bounds_text(known->bounds) == bounds_text(bounds),
      .bounds = bounds_text(bounds),
      .keeps_attribute_bounds = !splitting.asks_of_attributes && bounds.attributes.has_value(),
      .attribute_bounds = bounds.attributes ? attribute_bounds_text(*bounds.attributes) : "",
      .color_rms = state->attributes.color_rms.value_or(0)};
  std::vector<NewPart> parts;
  for (std::size_t i = 0; i < state->octets.size(); ++i) {
    const PartEntry& entry = state->manifest.entries[i];
    const bool is_new = !before || entry.revision > before->manifest.revision;
    if (!is_new && load_part(splitting.folder, entry)) continue;
    parts.push_back({entry.key, entry.revision, state->octets[i]});
    ++(is_new ? update.new_parts : update.mended_parts);
  }
  const auto saved = save_map_with_bounds(splitting.folder, state->manifest, parts, bounds);
  if (!saved) return fail(splitting.folder, saved.error());
  const double rounding =
      imported->report.position_error + rounding_in_map(imported->mesh, state->manifest.description);
  const std::uint64_t unreferenced = count_unreferenced(imported->mesh);
  if (splitting.json) {
    auto object = map_object(state->manifest);
    if (state->attributes.color_rms) object["color_rms"] = *state->attributes.color_rms;
    object.update({{"new_parts", update.new_parts},
                   {"mended_parts", update.mended_parts},
                   {"bounds", update.bounds},
                   {"keeps_bounds", update.keeps_bounds},
                   {"attribute_bounds", update.attribute_bounds},
                   {"keeps_attribute_bounds", update.keeps_attribute_bounds},
                   {"unreferenced_vertices", unreferenced},
                   {"left_out", left_out_array(imported->report)},
                   {"position_error", rounding},
                   {"uv_scale", imported->report.uv_scale}});
    print_json(object);
  } else {
    print_map(splitting.in + " -> " + splitting.folder, state->manifest, update);
    print_dropped(unreferenced, report_stream({}));
    print_rounding(rounding, report_stream({}));
    print_stretch(imported->report.uv_scale, report_stream({}));
    print_left_out(imported->report, report_stream({}));
  }
  return kOk;
}

}  // namespace

void add_map_split(CLI::App& map, int& status) {
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
      ->add_option("--part-triangles", splitting->most_triangles,
                   "parts with more are divided, down to an eighth of the edge")
      ->default_str(std::to_string(splitting->settings.most_triangles));
  command
      ->add_option(
          "--levels", splitting->levels,
          "coarser levels above the largest parts, each of cells of twice the edge; with any there are "
          "coarser copies of smaller parts, too")
      ->check(CLI::Range(0, int{kMostLevels}))
      ->default_str("0");
  command->add_option("--map-id", splitting->name.id, "which map")
      ->check(refuse_negative)
      ->default_str(std::to_string(splitting->settings.id));
  command->add_option("--frame", splitting->name.frame, "name of the coordinate frame")
      ->default_str(splitting->settings.frame);
  add_file_options(*command, splitting->files, true);
  add_part_quality(*command, splitting->settings.quality);
  command->add_flag("--json", splitting->json, "print one JSON object to standard output");
  command->footer(
      "Percentages count in the diagonal of the whole mesh when they are first asked for, and stay what they "
      "were then, however the map grows. Where DIR holds a map, other bounds on positions than those asked "
      "before replace them, all of them; without any, those are kept. The same holds of bounds on "
      "attributes, of the map's number and frame, of --levels and --part-triangles; another number, frame or "
      "--part-edge makes all parts anew, and so does a mesh from other voxels. "
      "Parts that stay as they are keep their files; those whose file is missing or damaged are written "
      "again.\n\n"
      "Colours of photographs are kept to 41 dB of PSNR, labels exactly.\n\n"
      "Example:\n  deltamesh map split kitchen.ply kitchen.map --part-edge 2 --max-error 0.001\n");
  command->callback([splitting, command, &status] {
    splitting->asks_of_attributes = asks_of_attributes(*command);
    status = run_split(*splitting);
  });
}

}  // namespace deltamesh::cli
