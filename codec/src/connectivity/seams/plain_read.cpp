// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/byte_reader.h"
#include "base/try.h"
#include "connectivity/faces/cut.h"
#include "connectivity/plain_forms.h"
#include "connectivity/seams/vertex.h"
#include "entropy/planes.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Geometric vertices with several copies.
struct SeamList {
  std::vector<std::uint32_t> slot;  ///< place in `seam` of every geometric vertex, or kNoIndex
  std::vector<SeamVertex> seam;
};

/// Errors: kTruncated, kInvalidStream [SEAM-2, SEAM-3].
Result<SeamList> read_seam_list(ByteReader& in, std::uint32_t geometric_count, std::uint32_t extra_copies) {
  DELTAMESH_TRY(const std::uint64_t count, in.read_varint());
  if (count == 0 || count > std::min(geometric_count, extra_copies))
    return in.invalid("count of split vertices out of range", "SEAM-2");
  DELTAMESH_TRY(const std::vector<std::uint32_t> gaps, read_planes(in, count));
  DELTAMESH_TRY(const std::vector<std::uint32_t> extra, read_planes(in, count));

  SeamList list;
  list.slot.assign(geometric_count, kNoIndex);
  list.seam.reserve(gaps.size());
  std::uint64_t next = 0;
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    next += gaps[i];
    if (next >= geometric_count) return in.invalid("split vertex out of range", "SEAM-2");
    list.slot[static_cast<std::size_t>(next++)] = static_cast<std::uint32_t>(i);
    total += std::uint64_t{extra[i]} + 1;
    if (total > extra_copies) return in.invalid("more copies than vertices", "SEAM-3");
    list.seam.push_back({.copies = extra[i] + 2});
  }
  if (total != extra_copies) return in.invalid("fewer copies than vertices", "SEAM-3");
  return list;
}

/// One choice for every corner at a split vertex but its first. Errors: kTruncated, kInvalidStream [SEAM-3].
Result<std::vector<std::uint32_t>> read_choices(ByteReader& in, const SeamList& list,
                                                std::span<const std::uint32_t> geometric_triangles) {
  std::vector<std::uint32_t> corners(list.seam.size(), 0);
  std::uint64_t total = 0;
  for (const std::uint32_t g : geometric_triangles) {
    if (list.slot[g] == kNoIndex) continue;
    ++corners[list.slot[g]];
    ++total;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] < list.seam[i].copies) return in.invalid("more copies than corners", "SEAM-3");
  }
  return read_planes(in, total - corners.size());
}

/// Copy of every corner, 0 where the geometric vertex has but one. Errors: kInvalidStream [SEAM-4].
Result<std::vector<std::uint32_t>> follow_choices(const ByteReader& in, SeamList& list,
                                                  std::span<const std::uint32_t> choices,
                                                  std::span<const std::uint32_t> geometric_triangles) {
  std::vector<std::uint32_t> copies(geometric_triangles.size(), 0);
  std::size_t next = 0;
  for (std::size_t c = 0; c < copies.size(); ++c) {
    const std::uint32_t s = list.slot[geometric_triangles[c]];
    if (s == kNoIndex) continue;
    SeamVertex& vertex = list.seam[s];
    if (vertex.used != 0) {
      const std::optional<std::uint32_t> copy = vertex.copy_of(choices[next++]);
      if (!copy) return in.invalid("no such copy", "SEAM-4");
      copies[c] = *copy;
    }
    vertex.take(copies[c]);
  }
  const bool all_used =
      std::all_of(list.seam.begin(), list.seam.end(), [](const SeamVertex& v) { return v.used == v.copies; });
  if (!all_used) return in.invalid("a copy that no corner uses", "SEAM-4");
  return copies;
}

}  // namespace

Result<CornerCopies> read_plain_copies(std::span<const std::byte> bytes,
                                       std::span<const std::uint32_t> geometric_triangles,
                                       std::uint32_t geometric_count, std::uint32_t extra_copies) {
  ByteReader in(bytes, kTagSeams);
  DELTAMESH_TRY(SeamList list, read_seam_list(in, geometric_count, extra_copies));
  DELTAMESH_TRY(const std::vector<std::uint32_t> choices, read_choices(in, list, geometric_triangles));
  DELTAMESH_CHECK(in.finish());
  CornerCopies copies;
  DELTAMESH_TRY(copies.of_corner, follow_choices(in, list, choices, geometric_triangles));
  copies.of_vertex.reserve(geometric_count);
  for (const std::uint32_t slot : list.slot)
    copies.of_vertex.push_back(slot == kNoIndex ? 1 : list.seam[slot].copies);
  return copies;
}

}  // namespace deltamesh
