// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes and streams in and out of files, with messages for people. "-" stands for standard input or output.
#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/io.h"
#include "exit_codes.h"

namespace deltamesh::cli {

/// Known suffixes, for help and messages.
inline constexpr const char* kMeshSuffixes = ".ply .obj .stl .off .gltf .glb";

/// How mesh files are read and written.
struct FileOptions {
  std::string format;         ///< of the mesh file, a suffix without its point; empty: as the suffix says
  bool strict = false;        ///< what is left out is an error
  bool drop_invalid = false;  ///< as ReadOptions
  bool are_options = false;   ///< the command has the options, so that messages may name them
};

/// Adds --format and --strict, and --drop-invalid for commands that read meshes.
void add_file_options(CLI::App& command, FileOptions& options, bool reads);

inline bool is_standard(const std::string& path) { return path == "-"; }

/// Where to report to while `output` is written: standard output, or standard error where it is the output.
std::ostream& report_stream(const std::string& output);

/// Whole files, or standard input and output.
Result<std::vector<std::byte>> read_input(const std::string& path);
Result<void> write_output(const std::string& path, std::span<const std::byte> bytes);

/// Reads a mesh; on failure prints why and leaves the exit code in `status`.
std::optional<Imported> load_mesh(const std::string& path, int& status, const FileOptions& options = {});

/// The same for what is about to be coded: a file without faces is refused, but for an empty one of which
/// nothing is left out, and points where the command `takes_points`.
std::optional<Imported> load_faces(const std::string& path, int& status, const FileOptions& options,
                                   bool takes_points = false);

/// Prints an error of coding the mesh of `path`; one about a vertex that is not finite with the option that
/// helps.
ExitCode fail_coding(const std::string& path, const Error& error);

struct LoadedStream {
  Mesh mesh;
  bool keeps_order;  ///< as StreamInfo
};
/// Reads and decodes a stream, likewise. `threads`: as DecodeOptions.
std::optional<LoadedStream> load_stream(const std::string& path, int& status, unsigned threads = 1);

/// Either of them, by the suffix; the format counts where there is none, and standard input without a format
/// is a stream.
std::optional<Imported> load_mesh_or_stream(const std::string& path, int& status, const FileOptions& options);

/// Whether a mesh can be written under this name; if not, says so and which names will do.
bool check_mesh_suffix(const std::string& path, int& status, const FileOptions& options = {});

/// Whether both paths lead to one regular file, or to one that is yet to be made; an empty path leads
/// nowhere.
bool names_same_file(const std::string& a, const std::string& b);

/// Whether `output` is another file than `input`; if not, says so.
bool check_keeps_input(const std::string& input, const std::string& output, int& status);

/// Whether no output is a file that the mesh at `input` names, such as a buffer or an image of a glTF asset;
/// if one is, says so.
bool check_keeps_files(const std::string& input, const ReadReport& report,
                       const std::vector<std::string>& outputs, int& status);

/// Whether `file` is outside `folder`, where the program removes what it did not write; if not, says
/// so.
bool check_is_outside(const std::string& folder, const std::string& file, int& status);

/// The same for the files that the mesh at `input` names and that are there.
bool check_are_outside(const std::string& folder, const std::string& input, const ReadReport& report,
                       int& status);

/// Writes a mesh, whole or not at all; returns the exit code. `report` gets what the format cannot hold;
/// without one it is printed. OBJ names a group wherever it changes: its faces are written group by group,
/// but where their order is to be kept.
int save_mesh(const std::string& path, MeshView mesh, const FileOptions& options = {},
              WriteReport* report = nullptr, bool keeps_order = false);

}  // namespace deltamesh::cli
