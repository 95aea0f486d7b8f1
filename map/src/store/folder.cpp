// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/folder.h"

#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <system_error>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/files.h"

namespace deltamesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestFile = "map.dmm";
constexpr const char* kPartFolder = "parts";

std::uint64_t hash_of_octets(std::span<const std::byte> bytes) noexcept {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::string path_in(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

/// Names of files that were written last a loss of power, as their content does.
void keep_names(const std::string& folder) noexcept {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)fsync(descriptor);
  (void)close(descriptor);
}

/// Files that no entry names, and what an interrupted run left; those that cannot be deleted do no harm.
void delete_others(const std::string& folder, const MapManifest& manifest) {
  std::set<std::string> named;
  for (const PartEntry& entry : manifest.entries)
    named.insert(fs::path(part_file(entry.key, entry.revision, entry.hash)).filename().string());
  std::error_code ignored;
  std::vector<fs::path> others;
  for (auto file = fs::directory_iterator(path_in(folder, kPartFolder), ignored);
       !ignored && file != fs::directory_iterator(); file.increment(ignored)) {
    const std::string name = file->path().filename().string();
    if (name.find(".part") != std::string::npos && !named.contains(name)) others.push_back(file->path());
  }
  for (const fs::path& other : others) fs::remove(other, ignored);
}

/// Files of a state that is being written. Deletes them again where that fails: a full disk stays as it was.
class NewFiles {
 public:
  NewFiles() = default;
  ~NewFiles() {
    std::error_code ignored;
    for (const std::string& path : paths_) fs::remove(path, ignored);
  }
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;

  /// A file that is there already has the same content and stays whatever happens.
  Result<void> write(const std::string& path, std::span<const std::byte> bytes) {
    std::error_code ignored;
    const bool is_new = !fs::exists(path, ignored);
    DELTAMESH_CHECK(write_file(path, bytes));
    if (is_new) paths_.push_back(path);
    return {};
  }
  void keep() noexcept { paths_.clear(); }

 private:
  std::vector<std::string> paths_;
};

}  // namespace

std::string part_file(const PartKey& key, std::uint64_t revision, std::uint64_t hash) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return std::string(kPartFolder) + '/' + std::to_string(key.level) + '_' + std::to_string(key.x) + '_' +
         std::to_string(key.y) + '_' + std::to_string(key.z) + '_' + std::to_string(revision) + '_' + digits +
         ".part";
}

Result<void> save_map(const std::string& folder, const MapManifest& manifest, std::span<const NewPart> parts,
                      std::span<const NewFile> others) noexcept {
  return guarded([&]() -> Result<void> {
    DELTAMESH_TRY(const auto bytes, write_manifest(manifest));
    std::error_code failed;
    fs::create_directories(path_in(folder, kPartFolder), failed);
    if (failed) return Error{.code = ErrorCode::kFileWrite, .message = "cannot make the map's folder"};
    NewFiles files;
    for (const NewPart& part : parts) {
      const std::string file = part_file(part.key, part.revision, hash_of_octets(part.bytes));
      DELTAMESH_CHECK(files.write(path_in(folder, file), part.bytes));
    }
    keep_names(path_in(folder, kPartFolder));
    std::vector<NewFile> together(others.begin(), others.end());
    const std::string manifest_file = path_in(folder, kManifestFile);
    together.push_back({manifest_file, bytes});
    DELTAMESH_CHECK(write_files(together));
    files.keep();
    keep_names(folder);
    delete_others(folder, manifest);
    return {};
  });
}

Result<MapManifest> load_map(const std::string& folder) noexcept {
  return guarded([&]() -> Result<MapManifest> {
    DELTAMESH_TRY(const auto bytes, read_file(path_in(folder, kManifestFile)));
    return read_manifest(bytes);
  });
}

Result<std::vector<std::byte>> load_part(const std::string& folder, const PartEntry& entry) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_TRY(auto bytes, read_file(path_in(folder, part_file(entry.key, entry.revision, entry.hash))));
    if (bytes.size() != entry.bytes || hash_of_octets(bytes) != entry.hash)
      return Error{.code = ErrorCode::kCorrupt,
                   .message = "a part's file does not hold what the manifest says",
                   .rule = "MAP-10"};
    return bytes;
  });
}

}  // namespace deltamesh
