// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Dispatch by format, and the checks that are common to all formats.
#include <algorithm>
#include <array>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"
#include "deltamesh/io.h"
#include "io/colors.h"
#include "io/formats.h"
#include "io/invalid_vertices.h"

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
