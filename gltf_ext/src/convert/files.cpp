// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <filesystem>
#include <string>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "io/gltf/uri.h"

namespace deltamesh {
namespace {

/// Where the bytes of an asset at `in` are, and those of its converted copy at `out` go.
Result<GltfIo> file_io(const std::filesystem::path& in, const std::string& out, std::string& buffer_path) {
  GltfIo io;
  io.resolve = [folder = in.parent_path()](std::string_view uri) {
    return read_file((folder / uri).string());
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

template <class Convert>
Result<GltfReport> convert_file(const std::string& in, const std::string& out, Convert&& convert) {
  std::string buffer_path;
  DELTAMESH_TRY(const GltfIo io, file_io(in, out, buffer_path));
  DELTAMESH_TRY(const auto asset, read_file(in));
  DELTAMESH_TRY(const GltfOutput output, convert(asset, io));
  if (!output.buffer.empty()) DELTAMESH_CHECK(write_file(buffer_path, output.buffer));
  DELTAMESH_CHECK(write_file(out, output.asset));
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
