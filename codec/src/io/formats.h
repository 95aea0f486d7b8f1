// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One reader and one writer per file format, as io.h dispatches to them. Writers may assume a valid view
// (checked by write_mesh()): sizes agree, indices are in range.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// Errors of all readers: kInvalidFile with line or byte. Bytes are not trusted: memory stays within a
/// constant times their number (glTF: see gltf/read.cpp).
Result<Imported> read_ply(std::span<const std::byte> bytes);
Result<Imported> read_obj(std::span<const std::byte> bytes);
Result<Imported> read_stl(std::span<const std::byte> bytes);
Result<Imported> read_off(std::span<const std::byte> bytes);
/// glTF and GLB, told apart by content. `folder`: where relative URIs are resolved; empty: no file is opened.
Result<Imported> read_gltf(std::span<const std::byte> bytes, std::string_view folder);

/// Of meshes that check_mesh() accepts, but for coordinates that are not finite.
std::vector<std::byte> write_ply(const MeshView& mesh, WriteReport& report);
std::vector<std::byte> write_obj(const MeshView& mesh, WriteReport& report);
std::vector<std::byte> write_off(const MeshView& mesh, WriteReport& report);
std::vector<std::byte> write_stl(const MeshView& mesh, WriteReport& report);
/// Precondition: coordinates are finite. Errors: kLimitExceeded (over 4 GiB).
Result<std::vector<std::byte>> write_gltf(const MeshView& mesh, bool binary, WriteReport& report);

}  // namespace deltamesh
