// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether an older version of a part will do for a newer source.
#pragma once

#include "deltamesh/map/messages.h"
#include "deltamesh/mesh.h"
#include "deltamesh/stream_info.h"

namespace deltamesh {

/// How much of a mean error of colours a part may have: its border's are on levels of their own.
inline constexpr double kMeanTolerance = 1.02;

/// Errors of a decoded part against a source.
struct PartErrors {
  double vde = 0;          ///< where vertices correspond
  double lfe = 0;          ///< the same
  double max_error = 0;    ///< largest distance of a vertex of either mesh to the surface of the other
  double color_error = 0;  ///< 255ths, the worst component, at those vertices and the points nearest to them
  double color_rms = 0;    ///< 255ths, over red, green and blue; of coded parts
};

/// Infinite errors where the meshes have attributes that are not colours, or other ones. Both are not empty
/// and have the same origin. O(n log n). Throws std::bad_alloc.
PartErrors errors_between(const Mesh& source, const Mesh& decoded);

/// Whether all that the view asks for is kept.
bool satisfies(const PartErrors& errors, const View& view) noexcept;

}  // namespace deltamesh
