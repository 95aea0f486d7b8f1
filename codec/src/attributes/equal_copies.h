// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices whose values are those of another copy of their geometric vertex [ATTR-36, ATTR-42]. One template
// for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "attributes/surface.h"
#include "attributes/surface_order.h"
#include "entropy/coder/model.h"

namespace deltamesh {

template <class Coder>
class EqualCopies {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// `surface` must outlive this.
  EqualCopies(Coder& coder, const AttributeSurface& surface)
      : coder_(coder), surface_(surface), equal_(surface.vertex_count()) {
    if (!surface.geometric().empty()) last_.assign(surface.vertex_count(), kNone);
  }

  /// The copy that was coded last, or kNone. Asked once for every vertex.
  std::uint32_t last(std::uint32_t vertex) noexcept {
    if (last_.empty()) return kNone;
    return std::exchange(last_[surface_.geometric_of(vertex)], vertex);
  }

  /// Codes whether vertex i of the surface order has the value of its last copy; there must be one. A
  /// reader's argument is ignored. The context is the sum of what the corners before it have: 1 if some
  /// differ from their copies, 2 if some are equal.
  bool code(std::size_t i, bool is_equal) {
    const SurfaceOrder& order = surface_.surface_order();
    unsigned context = 0;
    order.for_corners_before(i, [&](std::uint32_t before) { context |= equal_[before]; });
    is_equal = coder_.bit(is_equal, models_[context]);
    equal_[order.vertices[i]] = is_equal ? 2 : 1;
    return is_equal;
  }

 private:
  Coder& coder_;
  const AttributeSurface& surface_;
  std::array<BitModel, 4> models_;
  std::vector<std::uint8_t> equal_;  ///< 0 without a copy
  std::vector<std::uint32_t> last_;  ///< by geometric vertex
};

}  // namespace deltamesh
