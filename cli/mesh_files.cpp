// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "mesh_files.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <system_error>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/stream_info.h"
#include "report/console.h"
#include "report/losses.h"
#include "report/progress.h"

namespace deltamesh::cli {
namespace {

bool is_stream(const std::string& path) { return path.size() >= 5 && path.ends_with(".dmsh"); }

enum class Use : std::uint8_t { kRead, kWrite };

std::string no_format_text(const std::string& path, const FileOptions& options, Use use) {
  if (is_standard(path))
    return options.are_options
               ? "--format must say what is piped: ply, obj, stl, off, gltf or glb"
               : "this command writes no pipe; give a file name, whose suffix says the format";
  if (is_stream(path))
    return use == Use::kRead
               ? "this is a stream, not a mesh file; `deltamesh decode` makes a mesh of it"
               : std::string("this suffix is a stream's; a mesh file has one of ") + kMeshSuffixes;
  const std::string suffix = std::filesystem::path(path).extension();
  return (suffix.empty() ? "the name has no suffix" : "no mesh format has the suffix " + suffix) +
         "; known are " + kMeshSuffixes + (options.are_options ? ", and --format can say which it is" : "");
}

/// Of a mesh file; prints what is wrong with its name or --format.
std::optional<FileFormat> mesh_format(const std::string& path, const FileOptions& options, Use use,
                                      int& status) {
  const Result<FileFormat> format = format_of_path(options.format.empty() ? path : '.' + options.format);
  if (format) return *format;
  status = kUsage;
  print_error(path, no_format_text(path, options, use));
  return std::nullopt;
}

/// False, and an error on the terminal, where something is left out that may not be.
bool accept_losses(const std::string& path, const LossReport& report, const FileOptions& options) {
  if (!options.strict || report.left_out.empty()) return true;
  print_error(path, "left out, which --strict forbids: " + left_out_text(report));
  return false;
}

Result<Imported> read_showing_progress(const std::string& path, const ReadOptions& options) {
  const Progress progress("reading");
  if (!is_standard(path)) return read_mesh_file(path, options);
  const Result<std::vector<std::byte>> bytes = read_input(path);
  if (!bytes) return bytes.error();
  return read_mesh(*bytes, *options.format, {}, options);
}

Result<Mesh> decode_showing_progress(const std::vector<std::byte>& bytes, unsigned threads) {
  Progress progress("decoding");
  return decode(bytes, {.limits = {}, .threads = threads, .progress = progress.callback()});
}

/// Faces group by group, each group's in their order.
struct FacesByGroup {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> groups;

  explicit FacesByGroup(const MeshView& mesh) {
    std::vector<std::uint32_t> order(mesh.face_groups.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t t) { return mesh.face_groups[t]; });
    for (const std::uint32_t t : order) {
      const auto corners = mesh.triangles.subspan(3 * std::size_t{t}, 3);
      triangles.insert(triangles.end(), corners.begin(), corners.end());
      groups.push_back(mesh.face_groups[t]);
    }
  }
};

Result<std::vector<std::byte>> write_showing_progress(const MeshView& mesh, FileFormat format,
                                                      WriteReport& report) {
  const Progress progress("writing");
  return write_mesh(mesh, format, &report);
}

}  // namespace

void add_file_options(CLI::App& command, FileOptions& options, bool reads) {
  options.are_options = true;
  command
      .add_option("--format", options.format,
                  "format of the mesh file, in place of its suffix: ply, obj, stl, off, gltf or glb")
      ->check(CLI::IsMember({"ply", "obj", "stl", "off", "gltf", "glb"}));
  command.add_flag("--strict", options.strict, "fail where anything of a mesh file is left out");
  if (reads)
    command.add_flag("--drop-invalid", options.drop_invalid,
                     "drop faces at vertices that are NaN or infinite");
}

std::ostream& report_stream(const std::string& output) { return is_standard(output) ? std::cerr : std::cout; }

Result<std::vector<std::byte>> read_input(const std::string& path) {
  return read_file(is_standard(path) ? "/dev/stdin" : path);
}

Result<void> write_output(const std::string& path, std::span<const std::byte> bytes) {
  if (!is_standard(path)) return write_file(path, bytes);
  std::cout.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  std::cout.flush();
  if (std::cout) return {};
  return Error{.code = ErrorCode::kFileWrite, .message = "standard output cannot be written"};
}

std::optional<Imported> load_mesh(const std::string& path, int& status, const FileOptions& options) {
  const std::optional<FileFormat> format = mesh_format(path, options, Use::kRead, status);
  if (!format) return std::nullopt;
  Result<Imported> imported =
      read_showing_progress(path, {.drop_invalid = options.drop_invalid, .format = format});
  if (!imported) {
    status = fail(path, imported.error());
    return std::nullopt;
  }
  if (accept_losses(path, imported->report, options)) return *std::move(imported);
  status = kBadInput;
  return std::nullopt;
}

std::optional<Imported> load_faces(const std::string& path, int& status, const FileOptions& options,
                                   bool takes_points) {
  std::optional<Imported> imported = load_mesh(path, status, options);
  if (!imported || !imported->mesh.triangles.empty()) return imported;
  const std::uint64_t points = imported->mesh.vertex_count();
  const auto& left_out = imported->report.left_out;
  const bool had_some = std::ranges::any_of(left_out, [](const LeftOut& left) {
    return left.kind == LeftOutKind::kPrimitives || left.kind == LeftOutKind::kFaces;
  });
  if (points > 0 ? takes_points : !had_some) return imported;
  const std::string losses = left_out.empty() ? "" : left_out_text(imported->report);
  print_error(path, (points > 0 ? counted(points, "point", "points") + " and " : "") +
                        "no faces: nothing to code" + (losses.empty() ? "" : "; left out: " + losses));
  status = kBadInput;
  return std::nullopt;
}

ExitCode fail_coding(const std::string& path, const Error& error) {
  if (error.code != ErrorCode::kNotFinite) return fail(path, error);
  print_error(path, describe(error) + "; --drop-invalid drops the faces at such vertices");
  return kBadInput;
}

std::optional<LoadedStream> load_stream(const std::string& path, int& status, unsigned threads) {
  const Result<std::vector<std::byte>> bytes = read_input(path);
  if (!bytes) {
    status = fail(path, bytes.error());
    return std::nullopt;
  }
  Result<Mesh> mesh = decode_showing_progress(*bytes, threads);
  const Result<StreamInfo> info = inspect(*bytes);
  if (mesh && info) return LoadedStream{*std::move(mesh), info->keeps_order};
  status = fail(path, mesh ? info.error() : mesh.error());
  return std::nullopt;
}

std::optional<Imported> load_mesh_or_stream(const std::string& path, int& status,
                                            const FileOptions& options) {
  FileOptions own = options;
  if (format_of_path(path)) own.format.clear();
  if (!is_stream(path) && !(is_standard(path) && own.format.empty())) return load_mesh(path, status, own);
  std::optional<LoadedStream> stream = load_stream(path, status);
  if (!stream) return std::nullopt;
  return Imported{.mesh = std::move(stream->mesh), .report = {}};
}

bool check_mesh_suffix(const std::string& path, int& status, const FileOptions& options) {
  return mesh_format(path, options, Use::kWrite, status).has_value();
}

bool names_same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  if (a.empty() || b.empty() || is_standard(a) || is_standard(b)) return false;
  std::error_code absent;
  if (fs::exists(a, absent)) return fs::is_regular_file(a, absent) && fs::equivalent(a, b, absent);
  if (fs::path(a).filename() != fs::path(b).filename()) return false;  // canonical paths cost much more
  return fs::weakly_canonical(fs::absolute(a, absent), absent) ==
         fs::weakly_canonical(fs::absolute(b, absent), absent);
}

bool check_keeps_input(const std::string& input, const std::string& output, int& status) {
  if (!names_same_file(input, output)) return true;
  print_error(output, "the output would replace the input");
  status = kUsage;
  return false;
}

bool check_is_outside(const std::string& folder, const std::string& file, int& status) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
  fs::path above = fs::weakly_canonical(fs::absolute(file, ignored), ignored);
  while (above.has_relative_path() && above != whole) above = above.parent_path();
  if (is_standard(file) || above != whole) return true;
  print_error(file, "files in " + folder + " are removed when it is written; keep it elsewhere");
  status = kUsage;
  return false;
}

bool check_are_outside(const std::string& folder, const std::string& input, const ReadReport& report,
                       int& status) {
  namespace fs = std::filesystem;
  const fs::path own = fs::path(input).parent_path();
  return std::ranges::all_of(report.files, [&](const std::string& file) {
    std::error_code absent;
    if (!fs::exists(fs::symlink_status(own / file, absent))) return true;
    return check_is_outside(folder, (own / file).string(), status);
  });
}

bool check_keeps_files(const std::string& input, const ReadReport& report,
                       const std::vector<std::string>& outputs, int& status) {
  for (const std::string& file : report.files) {
    const std::string path = (std::filesystem::path(input).parent_path() / file).string();
    for (const std::string& output : outputs) {
      if (!names_same_file(path, output)) continue;
      print_error(output, "the output would replace a file that " + input + " names");
      status = kUsage;
      return false;
    }
  }
  return true;
}

int save_mesh(const std::string& path, MeshView mesh, const FileOptions& options, WriteReport* report,
              bool keeps_order) {
  int status = kOk;
  const std::optional<FileFormat> format = mesh_format(path, options, Use::kWrite, status);
  if (!format) return status;
  std::optional<FacesByGroup> faces;
  if (*format == FileFormat::kObj && !keeps_order && !mesh.face_groups.empty()) {
    faces.emplace(mesh);
    mesh.triangles = faces->triangles;
    mesh.face_groups = faces->groups;
  }
  WriteReport own;
  WriteReport& losses = report != nullptr ? *report : own;
  const Result<std::vector<std::byte>> bytes = write_showing_progress(mesh, *format, losses);
  if (!bytes) return fail(path, bytes.error());
  if (!accept_losses(path, losses, options)) return kCannotWrite;
  if (const Result<void> written = write_output(path, *bytes); !written) return fail(path, written.error());
  if (report == nullptr) print_left_out(losses, report_stream(path));
  return kOk;
}

}  // namespace deltamesh::cli
