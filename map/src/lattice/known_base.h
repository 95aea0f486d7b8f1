// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a part is coded beside, as the codec takes it [MAP-26].
#pragma once

#include <vector>

#include "deltamesh/known_mesh.h"
#include "deltamesh/map/part.h"
#include "lattice/place_border.h"

namespace deltamesh {

class KnownBase {
 public:
  /// `base`: decoded; must outlive this.
  explicit KnownBase(const MapPart& base)
      : positions_(streamed_positions(base)), mesh_{positions_, base.mesh.triangles, base.mesh.attributes} {}
  KnownBase(const KnownBase&) = delete;
  KnownBase& operator=(const KnownBase&) = delete;

  const KnownMesh* mesh() const noexcept { return &mesh_; }

 private:
  std::vector<float> positions_;
  KnownMesh mesh_;
};

}  // namespace deltamesh
