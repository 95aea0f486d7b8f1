// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh as files have it: polygons whose corners index positions and values apart; and the way from there to
// one index per corner and triangles.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// The corners of all faces, one face after the other: indices of positions, checked.
class Faces {
 public:
  /// False, and nothing but the count of such faces changes, for fewer than three corners.
  bool add(std::span<const std::uint32_t> corners) {
    if (corners.size() < 3) {
      ++dropped_;
      return false;
    }
    if (corners.size() > 3 && ends_.empty())
      for (std::size_t end = 3; end <= corners_.size(); end += 3) ends_.push_back(end);
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    if (corners.size() > 3 || !ends_.empty()) ends_.push_back(corners_.size());
    return true;
  }

  std::size_t count() const noexcept { return are_triangles() ? corners_.size() / 3 : ends_.size(); }
  std::uint64_t dropped() const noexcept { return dropped_; }
  bool are_triangles() const noexcept { return ends_.empty(); }
  std::span<const std::uint32_t> corners() const noexcept { return corners_; }
  std::vector<std::uint32_t> take_corners() noexcept { return std::move(corners_); }
  std::size_t begin(std::size_t face) const noexcept { return face == 0 ? 0 : end(face - 1); }
  std::size_t end(std::size_t face) const noexcept { return are_triangles() ? 3 * face + 3 : ends_[face]; }

 private:
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> ends_;  // one past the last corner of every face; empty while all are triangles
  std::uint64_t dropped_ = 0;
};

/// Values that faces or corners name by index.
struct CornerValues {
  static constexpr std::uint32_t kNone = 0xffffffff;  ///< a corner without: it gets zeros
  Attribute records;                                  ///< one value per record, in place of per vertex
  std::vector<std::uint32_t> index;                   ///< of the record, for every corner
};

/// Values of faces or corners in place of their indices: equal ones become one record. `owners`: the value of
/// every corner, or kNone.
CornerValues index_values(Attribute values, std::span<const std::uint32_t> owners);

struct PolygonMesh {
  std::vector<double> coordinates;          ///< n x 3
  std::vector<Attribute> attributes;        ///< n values each
  Faces faces;                              ///
  std::vector<CornerValues> corner_values;  ///< at most three
  std::vector<std::uint32_t> face_groups;   ///< of every face; or empty
  std::vector<GroupName> group_names;       ///< by group
};

/// One vertex per distinct corner. The first combination met of a position takes the position's own index, so
/// vertices keep the order of the file's positions (those no corner uses included); further combinations
/// follow in the order in which they are met. Corner values become attributes behind the others. `report`:
/// what is left out so far. Errors: kInvalidFile: more corners than a 32-bit index can name. Cost O(n log n).
Result<Imported> to_triangles(PolygonMesh mesh, ReadReport report);

}  // namespace deltamesh
