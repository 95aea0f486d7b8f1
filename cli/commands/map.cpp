// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "commands/map.h"

#include <algorithm>
#include <memory>
#include <string>

#include "commands/commands.h"
#include "deltamesh/map/encode_map.h"
#include "map_files.h"
#include "mesh_files.h"
#include "report/console.h"
#include "report/map.h"

namespace deltamesh::cli {
namespace {

struct Folders {
  std::string first;
  std::string second;
  std::uint8_t level = 0;
  FileOptions files;
  bool json = false;
};

int run_join(const Folders& folders) {
  int status = kOk;
  if (!check_mesh_suffix(folders.second, status, folders.files) ||
      !check_is_outside(folders.first + "/parts", folders.second, status) ||
      !check_keeps_input(folders.first + "/map.dmm", folders.second, status) ||
      !check_keeps_input(folders.first + "/bounds.json", folders.second, status))
    return status;
  const auto state = load_state(folders.first, status);
  if (!state) return status;
  if (const int top = top_level(keys_of(state->manifest)); folders.level > top) {
    print_error("--level " + std::to_string(folders.level),
                folders.first + " has the levels 0 to " + std::to_string(top));
    return kUsage;
  }
  const Result<Mesh> mesh = decode_map(*state, {}, folders.level);
  if (!mesh) return fail(folders.first, mesh.error());
  status = save_mesh(folders.second, *mesh, folders.files);
  if (status != kOk) return status;
  report_stream(folders.second) << folders.first << " -> " << folders.second << ": "
                                << counted(mesh->vertex_count(), "vertex", "vertices") << ", "
                                << counted(mesh->triangle_count(), "triangle", "triangles") << '\n';
  return kOk;
}

int run_map_info(const Folders& folders) {
  int status = kOk;
  const auto manifest = load_manifest(folders.first, status);
  if (!manifest) return status;
  if (folders.json)
    print_json(map_object(*manifest));
  else
    print_map(folders.first + ": deltamesh map", *manifest);
  return check_files(folders.first, *manifest);
}

int run_diff(const Folders& folders) {
  int status = kOk;
  const auto before = load_manifest(folders.first, status);
  if (!before) return status;
  const auto after = load_manifest(folders.second, status);
  if (!after) return status;
  status = std::max(check_files(folders.first, *before), check_files(folders.second, *after));
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
  if (folders.json) return print_json(object), status;
  Summary summary(folders.first + " -> " + folders.second);
  summary.add("what all parts share", is_same_epoch ? "is the same" : "is not the same");
  summary.add("differences", counted(list.size(), "part", "parts") + ", " + counted(bytes, "byte", "bytes"));
  summary.print();
  std::fputs(text.c_str(), stdout);
  return status;
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
  add_map_split(*map, status);
  add_folders(*map, status, "join", "Make one mesh file of a map", "OUT", "mesh file to write", run_join);
  add_folders(*map, status, "diff", "Tell which parts of two maps differ", "NEW", "folder of another one",
              run_diff);
  add_folders(*map, status, "info", "Tell what a map holds; decodes nothing", "", "", run_map_info);
}

}  // namespace deltamesh::cli
