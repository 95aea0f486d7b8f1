// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Updates of a map as a mapper gives them, in a folder: `sequence.json` and PLY files.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

using SequenceBlockId = std::array<std::int32_t, 3>;

struct SequenceBlock {
  SequenceBlockId id{};
  Mesh mesh;  ///< the block's whole content
};

/// Replacing the changed blocks and dropping the removed ones gives the map after the step.
struct SequenceStep {
  std::vector<SequenceBlock> changed;
  std::vector<SequenceBlockId> removed;
};

/// Block (i, j, k) is the cube from origin + block_metres * (i, j, k) on.
struct SequenceHeader {
  std::string description{};
  double voxel = 0;  ///< metres, above 0
  std::uint32_t block_voxels = 16;
  double block_metres = 0;  ///< above 0
  std::array<double, 3> origin{};
};

class SequenceReader {
 public:
  /// Reads `folder`/sequence.json. Errors: kFileOpen, kFileRead, kInvalidFile.
  static Result<SequenceReader> open(const std::string& folder);

  const SequenceHeader& header() const noexcept { return header_; }
  std::size_t size() const noexcept { return steps_.size(); }
  /// Errors: those of read_mesh_file(), kInvalidFile. Precondition: `step` below size().
  Result<SequenceStep> read(std::size_t step) const;
  /// The whole map after the step, welded; errors likewise.
  Result<Mesh> read_whole(std::size_t step) const;

 private:
  struct BlockRange {
    SequenceBlockId id{};
    std::size_t first_vertex = 0;
    std::size_t vertices = 0;
    std::size_t first_face = 0;
    std::size_t faces = 0;
  };
  struct Step {
    std::string changed;
    std::string whole;
    std::vector<BlockRange> blocks;
    std::vector<SequenceBlockId> removed;
  };
  static Result<SequenceBlock> cut_out(const Mesh& mesh, const BlockRange& range);

  std::string folder_;
  SequenceHeader header_;
  std::vector<Step> steps_;
};

/// Step by step; the folder is a sequence after each.
class SequenceWriter {
 public:
  /// Makes the folder where there is none. Errors: kFileWrite.
  static Result<SequenceWriter> create(const std::string& folder, SequenceHeader header);

  /// `blocks`: all of the map after the step. Errors: those of write_mesh_file().
  Result<void> add(const SequenceStep& step, std::span<const SequenceBlock> blocks);

  /// Vertices and triangles of the map after the last step.
  std::uint64_t vertices() const noexcept { return vertices_; }
  std::uint64_t triangles() const noexcept { return triangles_; }

 private:
  Result<void> write_json() const;

  std::string folder_;
  SequenceHeader header_;
  std::vector<std::string> steps_;  ///< as JSON
  std::uint64_t vertices_ = 0;
  std::uint64_t triangles_ = 0;
};

}  // namespace deltamesh
