// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "deltamesh/map/folder.h"
#include "deltamesh/map/map_codec.h"
#include "report/console.h"
#include "report/map.h"
#include "stored/tile_plan.h"

namespace deltamesh::cli {
namespace {

/// What writes parts again: maps of tiles are too large to be made at once.
std::string mending_of(const std::string& folder, const MapManifest& manifest) {
  std::string wrong;
  if (const auto tiles = has_plan(folder) ? load_plan(folder, wrong) : std::nullopt)
    if (tiles->plan.revision == manifest.revision && tiles->plan.description == manifest.description)
      return "; `deltamesh tiles finish` tells which tile to encode again";
  return "; `deltamesh map split` of the same mesh writes it again";
}

/// The same, looked up at the first part that needs it, as plans are as large as their maps. What it is made
/// of must outlive it.
class Mending {
 public:
  Mending(const std::string& folder, const MapManifest& manifest) : folder_(folder), manifest_(manifest) {}
  const std::string& text() {
    if (!text_) text_ = mending_of(folder_, manifest_);
    return *text_;
  }

 private:
  const std::string& folder_;
  const MapManifest& manifest_;
  std::optional<std::string> text_;
};

/// A part that is missing or cannot be read is damage of its map, as one with other content is.
ExitCode exit_code_of_part(const Error& error) {
  const bool is_file = error.code == ErrorCode::kFileOpen || error.code == ErrorCode::kFileRead;
  return is_file ? kBadStream : exit_code_of(error.code);
}

ExitCode fail_part(const std::string& folder, const PartEntry& entry, const Error& error,
                   const std::string& mending) {
  print_error(folder + ", part of " + key_text(entry.key), describe(error) + mending);
  return exit_code_of_part(error);
}

}  // namespace

void AskedName::set_in(MapSettings& settings, const MapDescription* before) const {
  if (before != nullptr) {
    settings.id = before->id;
    settings.frame = before->frame;
  }
  settings.id = id.value_or(settings.id);
  settings.frame = frame.value_or(settings.frame);
}

bool is_map(const std::string& folder) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(folder) / "map.dmm", ignored);
}

bool refuse_map(const std::string& path, const char* instead) {
  if (!is_map(path)) return false;
  print_error(path, std::string("this is a map's folder, not a stream; use `deltamesh ") + instead + '`');
  return true;
}

int check_files(const std::string& folder, const MapManifest& manifest) {
  int status = kOk;
  Mending mending(folder, manifest);
  for (const PartEntry& entry : manifest.entries) {
    const auto file = std::filesystem::path(folder) / part_file(entry.key, entry.revision, entry.hash);
    std::error_code failed;
    if (std::filesystem::file_size(file, failed) == entry.bytes && !failed) continue;
    print_error(file.string(), (failed ? "this part is missing" : "this part is damaged") + mending.text());
    status = kBadStream;
  }
  return status;
}

bool check_parts(const std::string& folder, const MapManifest& manifest, const std::string& mending,
                 int& status) {
  bool are_whole = true;
  for (const PartEntry& entry : manifest.entries) {
    const auto octets = load_part(folder, entry);
    if (octets) continue;
    status = std::max<int>(status, fail_part(folder, entry, octets.error(), mending));
    are_whole = false;
  }
  return are_whole;
}

int verify_map(const std::string& folder) {
  int status = kOk;
  const auto manifest = load_manifest(folder, status);
  if (!manifest) return status;
  const auto codec = MapCodec::open(manifest->description);
  if (!codec) return fail(folder, codec.error());
  Mending mending(folder, *manifest);
  for (const PartEntry& entry : manifest->entries) {
    const auto octets = load_part(folder, entry);
    const auto part = octets ? codec->decode(entry.key, *octets) : Result<MapPart>(octets.error());
    if (!part) status = std::max<int>(status, fail_part(folder, entry, part.error(), mending.text()));
  }
  if (status == kOk)
    std::cout << folder << ": ok, " << counted(manifest->entries.size(), "part", "parts") << '\n';
  return status;
}

std::optional<MapManifest> load_manifest(const std::string& folder, int& status) {
  if (!is_map(folder)) {
    print_error(folder, "no map is here: there is no file map.dmm");
    status = kBadInput;
    return std::nullopt;
  }
  auto manifest = load_map(folder);
  if (manifest) return *std::move(manifest);
  print_error((std::filesystem::path(folder) / "map.dmm").string(),
              describe(manifest.error()) + "; parts alone are no map: delete the folder and make it anew");
  status = exit_code_of(manifest.error().code);
  return std::nullopt;
}

std::optional<MapState> load_state(const std::string& folder, int& status) {
  auto manifest = load_manifest(folder, status);
  if (!manifest) return std::nullopt;
  MapState state{.manifest = *std::move(manifest)};
  for (const PartEntry& entry : state.manifest.entries) {
    auto octets = load_part(folder, entry);
    if (!octets) {
      status = fail_part(folder, entry, octets.error(), mending_of(folder, state.manifest));
      return std::nullopt;
    }
    state.octets.push_back(*std::move(octets));
  }
  return state;
}

}  // namespace deltamesh::cli
