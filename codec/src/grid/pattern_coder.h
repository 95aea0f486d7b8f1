// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Patterns that no cube with the same signs had before [GRD-6]. One template for both directions.
#pragma once

#include <optional>
#include <span>

#include "grid/cube/loops.h"
#include "grid/cube/pattern.h"
#include "grid/models.h"

namespace deltamesh::grid {

/// Triangles that fill loops, one after the other: each has the edge at which a polygon closes, and its
/// third corner, the apex, leaves a polygon on either side.
template <class GiveApex>
std::optional<Pattern> fill_loops(const Loops& loops, GiveApex give_apex) {
  Pattern pattern;
  std::array<std::span<const std::uint8_t>, kEdges> open;
  for (unsigned i = 0; i < loops.count(); ++i) {
    unsigned waiting = 0;
    open[waiting++] = loops[i];
    while (waiting > 0) {
      const std::span<const std::uint8_t> polygon = open[--waiting];
      if (polygon.size() < 3) continue;
      const std::optional<unsigned> apex = polygon.size() == 3 ? 1U : give_apex(polygon);
      if (!apex) return std::nullopt;
      pattern.add({polygon.back(), polygon.front(), polygon[*apex]});
      open[waiting++] = polygon.subspan(*apex);
      open[waiting++] = polygon.first(*apex + 1);
    }
  }
  pattern.sort();
  return pattern;
}

/// The corner of `polygon` at the third corner of the triangle of `pattern` over its closing edge, if any.
inline std::optional<unsigned> find_apex(std::span<const std::uint8_t> polygon, const Pattern& pattern) {
  for (unsigned apex = 1; apex + 1 < polygon.size(); ++apex) {
    const Triangle wanted = with_least_first({polygon.back(), polygon.front(), polygon[apex]}).corners;
    for (const Triangle& triangle : pattern.triangles())
      if (triangle == wanted) return apex;
  }
  return std::nullopt;
}

/// How ambiguous faces are joined so that `pattern` fills the loops; nothing where it fills none.
inline std::optional<unsigned> find_joins(Signs signs, const Pattern& pattern) {
  const unsigned ambiguous = ambiguous_faces(signs);
  for (unsigned joins = ambiguous;; joins = (joins - 1) & ambiguous) {
    const auto filled = fill_loops(Loops(signs, joins), [&](std::span<const std::uint8_t> polygon) {
      return find_apex(polygon, pattern);
    });
    if (filled == pattern) return joins;
    if (joins == 0) return std::nullopt;
  }
}

/// `pattern`: a writer's; a reader's is ignored. Nothing where a stream breaks GRD-6.
template <class Coder>
std::optional<Pattern> code_new_pattern(Coder& coder, Signs signs, const Pattern& pattern,
                                        PatternModels& models) {
  std::optional<unsigned> joins;
  if constexpr (Coder::kWrites) joins = find_joins(signs, pattern);
  if (!coder.bit(!joins.has_value(), models.is_any)) {
    unsigned around_outside = 0;
    const unsigned ambiguous = ambiguous_faces(signs);
    for (unsigned f = 0; f < kFaces; ++f) {
      if ((ambiguous >> f & 1) == 0) continue;
      if (coder.bit((joins.value_or(0) >> f & 1) != 0, models.around_outside)) around_outside |= 1U << f;
    }
    const auto coded = fill_loops(
        Loops(signs, around_outside), [&](std::span<const std::uint8_t> polygon) -> std::optional<unsigned> {
          const unsigned apex = Coder::kWrites ? find_apex(polygon, pattern).value_or(1) : 1;
          const unsigned symbol = coder.symbol(apex - 1, Mixture<1>{{&models.apex[polygon.size()]}});
          if (symbol + 2 >= polygon.size()) return std::nullopt;
          return symbol + 1;
        });
    return coded && !coded->triangles().empty() ? coded : std::nullopt;
  }
  Pattern coded;
  const unsigned count =
      coder.symbol(static_cast<unsigned>(pattern.triangles().size()), Mixture<1>{{&models.count}});
  for (unsigned t = 0; t < count; ++t) {
    Triangle triangle{};
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned corner = Coder::kWrites ? pattern.triangles()[t][k] : 0;
      triangle[k] = static_cast<std::uint8_t>(coder.symbol(corner, Mixture<1>{{&models.corner[k]}}));
      if (triangle[k] > kInside) return std::nullopt;
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      return std::nullopt;
    coded.add(triangle);
  }
  coded.sort();
  return count > 0 ? std::optional(coded) : std::nullopt;
}

}  // namespace deltamesh::grid
