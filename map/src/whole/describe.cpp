// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "whole/describe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "search/request.h"
#include "support/limits.h"

namespace deltamesh {
namespace {

/// The least of the bounds: a lattice that keeps it for border vertices leaves room for all.
double least_bound(const QualityRequest& request) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& bound : {request.vde, request.lfe, request.max_error})
    if (bound) least = std::min(least, bound->value);
  return least;
}

}  // namespace

Box box_of(std::span<const float> positions) noexcept {
  if (positions.empty()) return {};
  Box box = Box::empty();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    box.min[i % 3] = std::min(box.min[i % 3], double{positions[i]});
    box.max[i % 3] = std::max(box.max[i % 3], double{positions[i]});
  }
  return box;
}

QualityRequest request_of(const MeshView& mesh, const QualityRequest& asked) {
  const std::vector<Vec3> positions = widen_rows(mesh.positions);
  const Extent extent = extent_of(positions, Box::around(positions));
  if (asked.empty()) return {.max_error = QualityBound{default_error(mesh.triangles, positions, extent)}};
  QualityRequest request = asked;
  for (auto* bound : {&request.vde, &request.lfe, &request.max_error})
    if (*bound && (*bound)->unit == QualityUnit::kDiagonal)
      *bound = QualityBound{(*bound)->value / 100 * extent.diagonal};
  return request;
}

Result<MapDescription> describe_map(const MeshView& mesh, const std::optional<VoxelGrid>& grid,
                                    const MapSettings& settings, const QualityRequest& request, int finer) {
  MapDescription description{.id = settings.id, .frame = settings.frame, .grid = grid};
  const double least = least_bound(request);
  if (!std::isfinite(least) || !(least > 0))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a mesh without extent needs bounds in model units, not in percent"};
  description.lattice = {.origin = mesh.origin,
                         .step_exponent = std::max(step_exponent_for(least) - finer, kLeastStepExponent)};
  const double steps =
      std::round(std::ldexp(settings.part_edge, -kLevelsOfParts) / description.lattice.step());
  if (!(steps <= kMostCellSteps))
    return Error{
        .code = ErrorCode::kInvalidArgument,
        .message =
            "parts of more than 2^27 steps of the lattice; ask for smaller ones, or for a larger error",
        .rule = "MAP-3"};
  if (steps < 1)
    return Error{
        .code = ErrorCode::kInvalidArgument,
        .message = "parts of less than 8 steps of the lattice; ask for larger ones, or for a smaller error",
        .rule = "MAP-3"};
  description.cell_steps = static_cast<std::uint32_t>(steps);
  // Floors and walls are often at 0: a third of a cell, on every level, from where cells meet.
  const std::int64_t third = (std::int64_t{description.cell_steps} << kLevelsOfParts) / 3;
  description.cell_origin.fill(-static_cast<std::int32_t>(std::min<std::int64_t>(third, kMostLatticeSteps)));
  for (const AttributeView& a : mesh.attributes)
    description.attributes.push_back(
        {a.kind, a.type, a.components, a.normalized, std::string(a.name), a.linear});
  return description;
}

Result<void> validate(const MapSettings& settings) noexcept {
  const auto invalid = [](const char* message) {
    return Error{.code = ErrorCode::kInvalidArgument, .message = message};
  };
  if (!std::isfinite(settings.part_edge) || !(settings.part_edge > 0))
    return invalid("the edge of parts is not above 0");
  if (settings.most_triangles == 0) return invalid("parts of no triangles");
  if (settings.levels > kMostPartLevel - kLevelsOfParts) return invalid("more than 21 coarser levels");
  if (settings.frame.size() > kMostNameBytes) return invalid("the name of the frame has more than 255 bytes");
  const QualityRequest& bounds = settings.quality.bounds;
  for (const auto& bound : {bounds.vde, bounds.lfe, bounds.max_error})
    if (bound && !(bound->value > 0)) return invalid("a bound on positions is not above 0");
  if ((bounds.vde || bounds.lfe || bounds.max_error) && !std::isfinite(least_bound(bounds)))
    return invalid(
        "a map needs a bound on positions: there may be none on the largest error only beside others");
  if (bounds.target_bytes) return invalid("a map cannot be asked for a number of bytes");
  return {};
}

}  // namespace deltamesh
