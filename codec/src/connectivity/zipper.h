// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Brings the halves of a mesh together, which were coded apart [CONN-15, CONN-16].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "connectivity/border.h"
#include "deltamesh/result.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"

namespace deltamesh {

/// Boundary edges of the second half, one after the other from `item` on, that are those of the first half,
/// one before the other from `partner` on.
struct Zip {
  std::uint32_t item;
  std::uint32_t partner;
  std::uint32_t edges;
};

/// A manifold vertex of the second half that is one of the first.
struct ZippedVertex {
  std::uint32_t vertex;
  std::uint32_t onto;

  friend auto operator<=>(const ZippedVertex&, const ZippedVertex&) = default;
};

/// What zips bring together.
struct Zipped {
  std::vector<ZippedVertex> vertices;  ///< ascending, each once
  std::vector<ZippedVertex> more;      ///< must turn out to be the same vertices as well
};

/// Zips for all boundary edges of the second half that are between the same vertices of the mesh as one of
/// the first. `vertex`: of every manifold vertex, or nothing where each is its own. O(n log n) of the
/// boundary edges, and O(items).
std::vector<Zip> find_zips(const Border& first, const Border& second, std::span<const std::uint32_t> vertex);

/// Sews the borders, whose gaps are all finished. Errors: kInvalidStream [CONN-16]. O(n log n) of the zips'
/// edges.
Result<Zipped> close_zips(std::span<const Zip> zips, Border& first, Border& second);

/// As [CONN-16] says.
void write_zips(CompactWriter& writer, std::span<const Zip> zips, const Border& first, const Border& second);

/// And closes them. Made up where the reader failed. Errors: kInvalidStream [CONN-16].
Result<Zipped> read_zips(CompactReader& reader, Border& first, Border& second);

/// `vertex`: of every manifold vertex. Errors: kInvalidStream [CONN-16].
Result<void> check_zipped(const Zipped& zipped, std::span<const std::uint32_t> vertex);

}  // namespace deltamesh
