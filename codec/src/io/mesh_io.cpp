// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Dispatch by format, and the checks that are common to all formats.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"
#include "deltamesh/io.h"
#include "io/colors.h"
#include "io/formats.h"

namespace deltamesh {
namespace {

constexpr const char* kNoMemory = "the mesh does not fit into memory";

Result<Imported> read_as(std::span<const std::byte> bytes, FileFormat format, std::string_view folder) {
  switch (format) {
    case FileFormat::kPly:
      return read_ply(bytes);
    case FileFormat::kObj:
      return read_obj(bytes);
    case FileFormat::kStl:
      return read_stl(bytes);
    case FileFormat::kOff:
      return read_off(bytes);
    case FileFormat::kGltf:
    case FileFormat::kGlb:
      return read_gltf(bytes, folder);
  }
  return Error{.code = ErrorCode::kUnknownFormat, .message = "no importer for this format"};
}

/// No stream can hold other vertices.
bool is_finite(const Mesh& mesh, std::size_t vertex) noexcept {
  const float* const p = &mesh.positions[3 * vertex];
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// Drops the faces at vertices that are not finite, and tells the report how many.
void drop_invalid_faces(Imported& imported) {
  Mesh& mesh = imported.mesh;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto corners = std::span(mesh.triangles).subspan(3 * t, 3);
    if (!std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return is_finite(mesh, v); }))
      continue;
    std::copy(corners.begin(), corners.end(), &mesh.triangles[3 * kept]);
    if (!mesh.face_groups.empty()) mesh.face_groups[kept] = mesh.face_groups[t];
    ++kept;
  }
  imported.report.leave_out(LeftOutKind::kFaces, "at vertices that are not finite",
                            mesh.triangle_count() - kept);
  mesh.triangles.resize(3 * kept);
  if (!mesh.face_groups.empty()) mesh.face_groups.resize(kept);
}

/// Drops such vertices where no face uses them, likewise. Others keep their order.
void drop_invalid_unused(Imported& imported) {
  Mesh& mesh = imported.mesh;
  if (std::all_of(mesh.positions.begin(), mesh.positions.end(), [](float x) { return std::isfinite(x); }))
    return;
  const std::size_t count = mesh.vertex_count();
  std::vector<bool> dropped(count);
  for (std::size_t v = 0; v < count; ++v) dropped[v] = !is_finite(mesh, v);
  for (const std::uint32_t v : mesh.triangles) dropped[v] = false;
  const auto drops = static_cast<std::uint64_t>(std::count(dropped.begin(), dropped.end(), true));
  if (drops == 0) return;
  imported.report.leave_out(LeftOutKind::kElements, "vertices that are not finite and that no face uses",
                            drops);

  std::vector<float>& roundings = imported.roundings;
  std::vector<std::uint32_t> renamed(count);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < count; ++v) {
    if (dropped[v]) continue;
    renamed[v] = static_cast<std::uint32_t>(kept);
    imported.file_vertices.push_back(static_cast<std::uint32_t>(v));
    std::copy_n(&mesh.positions[3 * v], 3, &mesh.positions[3 * kept]);
    if (!roundings.empty()) std::copy_n(&roundings[3 * v], 3, &roundings[3 * kept]);
    for (Attribute& attribute : mesh.attributes) {
      const std::size_t size = attribute.components * component_size(attribute.type);
      std::memmove(&attribute.values[kept * size], &attribute.values[v * size], size);
    }
    ++kept;
  }
  mesh.positions.resize(3 * kept);
  if (!roundings.empty()) roundings.resize(3 * kept);
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(kept * attribute.components * component_size(attribute.type));
  for (std::uint32_t& v : mesh.triangles) v = renamed[v];
}

Result<Imported> read_with(std::span<const std::byte> bytes, FileFormat format, std::string_view folder,
                           const ReadOptions& options) {
  DELTAMESH_TRY(Imported imported, read_as(bytes, format, folder));
  if (options.drop_invalid) drop_invalid_faces(imported);
  drop_invalid_unused(imported);
  return imported;
}

Result<std::vector<std::byte>> write_as(const MeshView& mesh, FileFormat format, WriteReport& report) {
  std::vector<Attribute> colors;
  switch (format) {
    case FileFormat::kPly:
      return write_ply(with_shown_colors(mesh, colors, report), report);
    case FileFormat::kObj:
      return write_obj(with_shown_colors(mesh, colors, report), report);
    case FileFormat::kStl:
      return write_stl(mesh, report);
    case FileFormat::kOff:
      return write_off(with_shown_colors(mesh, colors, report), report);
    case FileFormat::kGltf:
      return write_gltf(with_linear_colors(mesh, colors), false, report);
    case FileFormat::kGlb:
      return write_gltf(with_linear_colors(mesh, colors), true, report);
  }
  return Error{.code = ErrorCode::kUnknownFormat, .message = "no exporter for this format"};
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == path.npos) return ".";
  return path.substr(0, slash + 1);
}

}  // namespace

Result<FileFormat> format_of_path(std::string_view path) noexcept {
  constexpr std::array<std::pair<std::string_view, FileFormat>, 6> kSuffixes{{{".ply", FileFormat::kPly},
                                                                              {".obj", FileFormat::kObj},
                                                                              {".stl", FileFormat::kStl},
                                                                              {".off", FileFormat::kOff},
                                                                              {".gltf", FileFormat::kGltf},
                                                                              {".glb", FileFormat::kGlb}}};
  const auto same_letter = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  for (const auto& [suffix, format] : kSuffixes) {
    if (path.size() < suffix.size()) continue;
    const std::string_view end = path.substr(path.size() - suffix.size());
    if (std::equal(end.begin(), end.end(), suffix.begin(), same_letter)) return format;
  }
  return Error{.code = ErrorCode::kUnknownFormat,
               .message = "the file name must end in .ply, .obj, .stl, .off, .gltf or .glb"};
}

Result<Imported> read_mesh(std::span<const std::byte> bytes, FileFormat format, std::string_view folder,
                           const ReadOptions& options) noexcept {
  return guarded([&] { return read_with(bytes, format, folder, options); }, kNoMemory);
}

Result<Imported> read_mesh_file(const std::string& path, const ReadOptions& options) noexcept {
  FileFormat format{};
  if (options.format) {
    format = *options.format;
  } else {
    DELTAMESH_TRY(format, format_of_path(path));
  }
  DELTAMESH_TRY(const std::vector<std::byte> bytes, read_file(path));
  return guarded([&] { return read_with(bytes, format, folder_of(path), options); }, kNoMemory);
}

Result<std::vector<std::byte>> write_mesh(const MeshView& mesh, FileFormat format,
                                          WriteReport* report) noexcept {
  // Text may say "nan", which glTF forbids.
  const bool finite = format == FileFormat::kGltf || format == FileFormat::kGlb;
  DELTAMESH_CHECK(check_mesh(mesh, finite));
  const auto write = [&] {
    WriteReport unwanted;
    return write_as(mesh, format, report != nullptr ? *report : unwanted);
  };
  return guarded(write, kNoMemory);
}

Result<void> write_mesh_file(const std::string& path, const MeshView& mesh, WriteReport* report) noexcept {
  DELTAMESH_TRY(const FileFormat format, format_of_path(path));
  DELTAMESH_TRY(const std::vector<std::byte> bytes, write_mesh(mesh, format, report));
  return write_file(path, bytes);
}

}  // namespace deltamesh
