// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "base/with_found.h"
#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "io/gltf/uri.h"

namespace deltamesh {
namespace {

/// Where the bytes of an asset at `in` are, and those of its converted copy at `out` go. `read`: gets the
/// files that are read besides, and must outlive the result.
Result<GltfIo> file_io(const std::filesystem::path& in, const std::string& out, std::string& buffer_path,
                       std::vector<std::filesystem::path>& read) {
  GltfIo io;
  io.resolve = [folder = in.parent_path(), &read](std::string_view uri) {
    read.push_back(folder / uri);
    return read_file(read.back().string());
  };
  DELTAMESH_TRY(const auto format, format_of_path(out));
  if (format == FileFormat::kGlb) return io;
  if (format != FileFormat::kGltf)
    return Error{.code = ErrorCode::kUnknownFormat, .message = "the suffix is neither .glb nor .gltf"};
  const auto buffer = std::filesystem::path(out).replace_extension(".bin");
  io.container = GltfContainer::kGltf;
  io.buffer_uri = gltf::uri_of_name(buffer.filename().string());
  buffer_path = buffer.string();
  return io;
}

struct Copy {
  std::filesystem::path path;
  std::vector<std::byte> bytes;
};

bool is_same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(a).parent_path(), ignored) ==
         std::filesystem::weakly_canonical(std::filesystem::absolute(b).parent_path(), ignored);
}

/// The files that have to be written so that relative URIs of an asset that was at `in` hold at `out`.
/// `taken`: what is written besides.
Result<std::vector<Copy>> files_to_copy(const std::vector<std::string>& uris, const std::filesystem::path& in,
                                        const std::filesystem::path& out,
                                        const std::vector<std::filesystem::path>& taken, GltfReport& report) {
  std::vector<Copy> files;
  if (is_same_folder(in, out)) return files;
  for (const std::string& uri : uris) {
    const auto path = gltf::relative_path_of(uri);
    if (!path)
      return with_found(
          {.code = ErrorCode::kInvalidFile,
           .message = "the asset names a file outside its folder, which cannot go with it to another one"},
          uri);
    const auto source = read_file((in.parent_path() / *path).string());
    if (!source && source.error().code == ErrorCode::kFileOpen) {
      ++report.missing_files;  // the link was broken before
      continue;
    }
    if (!source) return source.error();
    const std::filesystem::path target = out.parent_path() / *path;
    const auto there = read_file(target.string());
    const bool is_taken = std::find(taken.begin(), taken.end(), target) != taken.end();
    if (is_taken || (there && *there != *source))
      return with_found({.code = ErrorCode::kFileWrite,
                         .message = "a file that the asset names would replace another one there"},
                        uri);
    if (!there) files.push_back({target, *source});
  }
  return files;
}

/// The asset, its buffer and what goes with it: all or none. `buffer`: its path.
Result<void> write_asset(const std::string& out, const std::string& buffer, const GltfOutput& output,
                         const std::vector<Copy>& copies) {
  std::vector<NewFile> files;
  for (const Copy& copy : copies) {
    std::error_code failed;
    std::filesystem::create_directories(copy.path.parent_path(), failed);
    files.push_back({copy.path.string(), copy.bytes});
  }
  if (!output.buffer.empty()) files.push_back({buffer, output.buffer});
  files.push_back({out, output.asset});
  const Result<void> written = write_files(files);
  if (written) return {};
  const std::size_t at_fault = written.error().where;
  if (at_fault + 1 == files.size()) return written.error();
  return with_found(written.error(), std::filesystem::path(files[at_fault].path).filename().string());
}

/// What an asset at `in` consists of beside itself: `read` and the files of `uris`.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& in,
                                            std::vector<std::filesystem::path> read,
                                            const std::vector<std::string>& uris) {
  for (const std::string& uri : uris)
    if (const auto path = gltf::relative_path_of(uri)) read.push_back(in.parent_path() / *path);
  return read;
}

Result<void> check_keeps_files(const std::vector<std::filesystem::path>& files, const std::string& output) {
  std::error_code absent;
  for (const std::filesystem::path& file : files)
    if (std::filesystem::equivalent(file, output, absent))
      return with_found(
          {.code = ErrorCode::kFileWrite, .message = "the output would replace a file of the asset"},
          file.filename().string());
  return {};
}

template <class Convert>
Result<GltfReport> convert_file(const std::string& in, const std::string& out, Convert&& convert) {
  std::string buffer_path;
  std::vector<std::filesystem::path> read;
  DELTAMESH_TRY(const GltfIo io, file_io(in, out, buffer_path, read));
  DELTAMESH_TRY(const auto asset, read_file(in));
  DELTAMESH_TRY(GltfOutput output, convert(asset, io));
  const auto own = files_of(in, read, output.uris);
  DELTAMESH_CHECK(check_keeps_files(own, out));
  if (!output.buffer.empty()) DELTAMESH_CHECK(check_keeps_files(own, buffer_path));
  DELTAMESH_TRY(const auto copies, files_to_copy(output.uris, in, out, {out, buffer_path}, output.report));
  DELTAMESH_CHECK(write_asset(out, buffer_path, output, copies));
  output.report.copied_files = copies.size();
  return output.report;
}

}  // namespace

Result<GltfReport> pack_gltf_file(const std::string& in, const std::string& out,
                                  const GltfPackOptions& options) noexcept {
  return guarded([&] {
    return convert_file(in, out, [&](std::span<const std::byte> asset, const GltfIo& io) {
      return pack_gltf(asset, options, io);
    });
  });
}

Result<GltfReport> unpack_gltf_file(const std::string& in, const std::string& out,
                                    const DecodeOptions& options) noexcept {
  return guarded([&] {
    return convert_file(in, out, [&](std::span<const std::byte> asset, const GltfIo& io) {
      return unpack_gltf(asset, options, io);
    });
  });
}

}  // namespace deltamesh
