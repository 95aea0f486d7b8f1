// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/welded_mesh.h"

#include <utility>

#include "topology/weld.h"

namespace deltamesh {

std::vector<std::uint8_t> find_referenced(const MeshView& mesh) {
  std::vector<std::uint8_t> referenced(mesh.vertex_count());
  for (const std::uint32_t v : mesh.triangles) referenced[v] = 1;
  return referenced;
}

WeldedMesh weld_mesh(const MeshView& mesh, const std::vector<std::uint8_t>& referenced, bool drops) {
  Weld weld = weld_by_position(mesh.positions, referenced);
  WeldedMesh welded;
  welded.has_seams = weld.representative.size() < referenced.size();
  if (!welded.has_seams && !drops) {
    welded.triangles = mesh.triangles;
    welded.representative = std::move(weld.representative);
    return welded;
  }
  std::vector<std::uint32_t> number(weld.representative.size(), kDropped);
  for (std::uint32_t g = 0; g < number.size(); ++g) {
    if (drops && referenced[weld.representative[g]] == 0) continue;
    number[g] = static_cast<std::uint32_t>(welded.representative.size());
    welded.representative.push_back(weld.representative[g]);
  }
  welded.geometric = std::move(weld.geometric);
  for (std::uint32_t& g : welded.geometric) g = number[g];
  welded.renumbered.reserve(mesh.triangles.size());
  for (const std::uint32_t v : mesh.triangles) welded.renumbered.push_back(welded.geometric[v]);
  welded.triangles = welded.renumbered;
  return welded;
}

}  // namespace deltamesh
