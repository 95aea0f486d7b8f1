// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Faces of a file, turned into triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// Collects polygons as triangle fans around their first corner. Faces of fewer than three corners are
/// dropped and counted. Indices must have been checked.
class FaceCollector {
 public:
  void add(std::span<const std::uint32_t> corners) {
    if (corners.size() < 3) {
      ++dropped_;
      return;
    }
    if (corners.size() > 3) ++polygons_;
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles_.insert(triangles_.end(), {corners[0], corners[i - 1], corners[i]});
  }

  void move_into(Imported& imported) {
    imported.mesh.triangles = std::move(triangles_);
    imported.notes.polygons = polygons_;
    imported.notes.dropped_faces = dropped_;
  }

 private:
  std::vector<std::uint32_t> triangles_;
  std::uint64_t polygons_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace deltamesh
