// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "lattice/positions.h"
#include "split/assemble.h"
#include "support/row_gather.h"

namespace deltamesh {
namespace {

/// Positions whose vertices stay where they are, ascending.
using FixedPositions = std::vector<PositionBits>;

bool is_fixed(const FixedPositions& fixed, const Mesh& mesh, std::size_t vertex) {
  return std::ranges::binary_search(fixed, bits_of(mesh, vertex));
}

/// Faces of each group by themselves.
std::vector<Mesh> groups_of(const Mesh& mesh) {
  if (mesh.face_groups.empty()) return {mesh};
  std::map<std::uint32_t, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) faces[mesh.face_groups[f]].push_back(f);
  std::vector<Mesh> groups;
  RowGather gather{MeshView(mesh)};
  for (const auto& [group, list] : faces) {
    for (const std::size_t f : list) gather.add_face(f);
    groups.push_back(gather.take());
  }
  return groups;
}

/// Border positions, and those in several groups.
FixedPositions fixed_positions(const MapPart& part, const std::vector<Mesh>& groups) {
  FixedPositions fixed;
  for (const BorderVertex& border : part.border) fixed.push_back(bits_of(part.mesh, border.vertex));
  if (groups.size() > 1) {
    FixedPositions all;
    for (const Mesh& group : groups) {
      FixedPositions own;
      for (std::size_t v = 0; v < group.vertex_count(); ++v) own.push_back(bits_of(group, v));
      std::ranges::sort(own);
      all.insert(all.end(), own.begin(), std::unique(own.begin(), own.end()));
    }
    std::ranges::sort(all);
    for (std::size_t i = 1; i < all.size(); ++i)
      if (all[i] == all[i - 1]) fixed.push_back(all[i]);
  }
  std::ranges::sort(fixed);
  return fixed;
}

/// Four vertices beyond all others. The simplifier keeps a vertex that is at the open edges of two fans, so
/// that a vertex stays where it gets two triangles with these: (v, 0, 1) and (v, 2, 3).
constexpr std::uint32_t kHolders = 4;

void add_holders(std::vector<float>& positions) {
  std::array<float, 3> high{positions[0], positions[1], positions[2]};
  for (std::size_t i = 0; i < positions.size(); ++i) high[i % 3] = std::max(high[i % 3], positions[i]);
  for (std::uint32_t i = 0; i < kHolders; ++i) {
    high[0] = std::nextafter(high[0], std::numeric_limits<float>::infinity());
    positions.insert(positions.end(), high.begin(), high.end());
  }
}

/// Edges twice as long.
constexpr std::size_t kFewer = 4;

/// The faces of a group once it is simplified. First open edges stay where they are, as they are what the
/// error is measured least at; they may move where too many faces are left then.
std::vector<std::uint32_t> simplified_faces(const Mesh& mesh, const FixedPositions& fixed, double max_error) {
  if (mesh.triangles.empty()) return {};
  const auto holder = static_cast<std::uint32_t>(mesh.vertex_count());
  std::vector<float> positions = mesh.positions;
  add_holders(positions);
  std::vector<std::uint32_t> faces = mesh.triangles;
  for (std::uint32_t v = 0; v < holder; ++v)
    if (is_fixed(fixed, mesh, v))
      faces.insert(faces.end(), {v, holder, holder + 1, v, holder + 2, holder + 3});
  const std::size_t stride = 3 * sizeof(float);
  const std::size_t count = positions.size() / 3;
  const float error = static_cast<float>(max_error) / meshopt_simplifyScale(positions.data(), count, stride);
  const std::size_t holding = faces.size() - mesh.triangles.size();
  const std::size_t target = holding + mesh.triangle_count() / kFewer * 3;
  std::vector<std::uint32_t> kept(faces.size());
  for (const unsigned option : {unsigned{meshopt_SimplifyLockBorder}, 0U}) {
    kept.resize(faces.size());
    kept.resize(meshopt_simplify(kept.data(), faces.data(), faces.size(), positions.data(), count, stride,
                                 target, error, option, nullptr));
    if (kept.size() <= holding + mesh.triangles.size() / 2) break;
  }
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < kept.size(); i += 3)
    if (std::max({kept[i], kept[i + 1], kept[i + 2]}) < holder)
      result.insert(result.end(), kept.begin() + static_cast<std::ptrdiff_t>(i),
                    kept.begin() + static_cast<std::ptrdiff_t>(i + 3));
  return result;
}

std::vector<BorderPosition> border_of(const MapPart& part) {
  std::vector<BorderPosition> border;
  for (const BorderVertex& b : part.border) border.push_back({bits_of(part.mesh, b.vertex), b.point, b.twin});
  std::ranges::sort(border);
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

}  // namespace

MapPart simplify(const MapPart& part, double max_error) {
  std::vector<Mesh> groups = groups_of(part.mesh);
  const FixedPositions fixed = fixed_positions(part, groups);
  std::vector<StoredBlock> blocks;
  for (Mesh& group : groups) {
    group.triangles = simplified_faces(group, fixed, max_error);
    if (!group.face_groups.empty()) group.face_groups.resize(group.triangle_count());
    RowGather gather{MeshView(group)};
    for (std::size_t f = 0; f < group.triangle_count(); ++f) gather.add_face(f);
    blocks.push_back({gather.take(), 0});
  }
  std::vector<const StoredBlock*> list;
  list.reserve(blocks.size());
  for (const StoredBlock& block : blocks) list.push_back(&block);
  const std::vector<BorderPosition> border = border_of(part);
  MapPart coarse = assemble(part.key, list, border);
  // Whatever the simplifier takes for fixed: without a crack or not at all.
  return border_of(coarse) == border ? coarse : part;
}

}  // namespace deltamesh
