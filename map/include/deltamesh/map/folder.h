// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map as a folder: a manifest, and a file for each part.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/files.h"
#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_entry.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct MapManifest {
  MapDescription description{};
  std::uint64_t revision = 0;  ///< of the newest update
  std::uint64_t next_group = 0;
  std::vector<PartEntry> entries{};  ///< ascending by key
};

/// Errors: kInvalidArgument (entries out of order, out of range), kOutOfMemory.
Result<std::vector<std::byte>> write_manifest(const MapManifest& manifest) noexcept;
/// Errors: 1xx codes [MAP-10], kOutOfMemory. Takes memory in proportion to the bytes.
Result<MapManifest> read_manifest(std::span<const std::byte> bytes) noexcept;

/// The file of a part's octets within a map's folder, such as "parts/0_-1_2_0_17_0123456789abcdef.part".
/// Other octets have another name, so that a state on disk stays whole while the next is written.
std::string part_file(const PartKey& key, std::uint64_t revision, std::uint64_t hash);

struct NewPart {
  PartKey key{};
  std::uint64_t revision = 0;
  std::span<const std::byte> bytes{};
};

/// Makes `folder` hold `manifest`: writes the files of `parts`, then replaces the manifest by renaming, then
/// deletes the files that no entry names. Interrupted at any point, the folder holds the old state or the
/// new; where writing fails, the new files are deleted. Every entry's file is there already or among `parts`.
/// `others`: what else belongs to the state, replaced just before the manifest, as by write_files(): they are
/// new beside an old manifest where the program ends, or a rename fails, in between. Errors: kFileOpen,
/// kFileWrite, as write_manifest().
Result<void> save_map(const std::string& folder, const MapManifest& manifest, std::span<const NewPart> parts,
                      std::span<const NewFile> others = {}) noexcept;

/// Errors: kFileOpen, kFileRead, as read_manifest().
Result<MapManifest> load_map(const std::string& folder) noexcept;

/// The octets of an entry, whose length and hash are checked. Errors: kFileOpen, kFileRead, kCorrupt.
Result<std::vector<std::byte>> load_part(const std::string& folder, const PartEntry& entry) noexcept;

}  // namespace deltamesh
