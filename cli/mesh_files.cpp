// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "mesh_files.h"

#include <filesystem>
#include <system_error>

#include "deltamesh/decode.h"
#include "report/console.h"
#include "report/progress.h"

namespace deltamesh::cli {
namespace {

bool is_stream(const std::string& path) { return path.size() >= 5 && path.ends_with(".dmsh"); }

int fail_with_suffixes(const std::string& path, const Error& error) {
  if (error.code != ErrorCode::kUnknownFormat) return fail(path, error);
  print_error(path, is_stream(path)
                        ? "this is a stream, not a mesh file; `deltamesh decode` makes a mesh of it"
                        : std::string("no mesh format has this suffix; known are ") + kMeshSuffixes);
  return kUsage;
}

Result<Imported> read_showing_progress(const std::string& path) {
  const Progress progress("reading");
  return read_mesh_file(path);
}

Result<Mesh> decode_showing_progress(const std::vector<std::byte>& bytes, unsigned threads) {
  Progress progress("decoding");
  return decode(bytes, {.limits = {}, .threads = threads, .progress = progress.callback()});
}

Result<void> write_showing_progress(const std::string& path, const MeshView& mesh) {
  const Progress progress("writing");
  return write_mesh_file(path, mesh);
}

}  // namespace

std::optional<Imported> load_mesh(const std::string& path, int& status) {
  Result<Imported> imported = read_showing_progress(path);
  if (imported) return *std::move(imported);
  status = fail_with_suffixes(path, imported.error());
  return std::nullopt;
}

std::optional<Mesh> load_stream(const std::string& path, int& status, unsigned threads) {
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) {
    status = fail(path, bytes.error());
    return std::nullopt;
  }
  Result<Mesh> mesh = decode_showing_progress(*bytes, threads);
  if (mesh) return *std::move(mesh);
  status = fail(path, mesh.error());
  return std::nullopt;
}

std::optional<Mesh> load_mesh_or_stream(const std::string& path, int& status) {
  if (is_stream(path)) return load_stream(path, status);
  std::optional<Imported> imported = load_mesh(path, status);
  if (!imported) return std::nullopt;
  return std::move(imported->mesh);
}

bool check_mesh_suffix(const std::string& path, int& status) {
  const Result<FileFormat> format = format_of_path(path);
  if (format) return true;
  print_error(path, std::string("cannot write a mesh under this suffix; known are ") + kMeshSuffixes);
  status = exit_code_of(format.error().code);
  return false;
}

bool names_same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  if (a.empty() || b.empty()) return false;
  std::error_code absent;
  if (fs::exists(a, absent)) return fs::is_regular_file(a, absent) && fs::equivalent(a, b, absent);
  return fs::weakly_canonical(fs::absolute(a, absent), absent) ==
         fs::weakly_canonical(fs::absolute(b, absent), absent);
}

int save_mesh(const std::string& path, const MeshView& mesh) {
  if (const Result<void> written = write_showing_progress(path, mesh); !written)
    return fail(path, written.error());
  return kOk;
}

}  // namespace deltamesh::cli
