// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/scan.h"

#include <algorithm>
#include <cmath>

#include "field/noise.h"

namespace deltamesh::scenes {
namespace {

constexpr std::uint32_t kBlock = 8;   ///< voxels along a block
constexpr std::uint32_t kCoarse = 4;  ///< voxels between places whose visibility is traced
constexpr double kRange = 6;          ///< metres a camera sees

double field(const Room& room, std::span<const Item* const> items, const Point& p) noexcept {
  double d = shell_distance(room, p);
  for (const Item* item : items) d = std::min(d, distance(*item, p));
  return d;
}

double field(const Room& room, const Point& p) noexcept {
  double d = shell_distance(room, p);
  for (const Item& item : room.items) d = std::min(d, distance(item, p));
  return d;
}

std::uint32_t coarse_count(std::uint32_t nodes) noexcept { return (nodes + kCoarse - 1) / kCoarse + 1; }

}  // namespace

Scan::Scan(const Building& building, const Lattice& lattice, std::uint64_t seed)
    : building_(building), lattice_(lattice), seed_(seed), truncation_(3 * lattice.voxel) {
  slab_.resize(kBlock * lattice.layer_size());
  visibility_.resize(std::size_t{kBlock / kCoarse + 1} * coarse_count(lattice.nodes[1]) *
                     coarse_count(lattice.nodes[2]));
}

std::span<const float> Scan::layer(std::uint32_t i) {
  if (i % kBlock == 0) fill_slab(i);
  return std::span(slab_).subspan((i % kBlock) * lattice_.layer_size(), lattice_.layer_size());
}

void Scan::fill_slab(std::uint32_t first) {
  slab_first_ = first;
  std::fill(slab_.begin(), slab_.end(), kUnobserved);
  std::fill(visibility_.begin(), visibility_.end(), -1.0F);
  for (std::uint32_t j = 0; j < lattice_.nodes[1]; j += kBlock)
    for (std::uint32_t k = 0; k < lattice_.nodes[2]; k += kBlock) fill_block(first, j, k);
}

/// Leaves the block unobserved where no cube that touches it can hold a surface. The field changes by at most
/// one metre per metre, but not across the middle of a wall, where the room changes: there the walls
/// themselves are near.
void Scan::fill_block(std::uint32_t first, std::uint32_t j, std::uint32_t k) {
  const double half = kBlock / 2.0;
  const Point centre = lattice_.at(first + half, j + half, k + half);
  const double reach = (half + 2) * lattice_.voxel * std::sqrt(3.0);
  const double to_surface = field(building_.room_at(centre), centre);
  if (std::fabs(to_surface) > reach + kWallThickness + 0.05) return;

  const Room* room = nullptr;
  const std::uint32_t j_end = std::min(j + kBlock, lattice_.nodes[1]);
  const std::uint32_t k_end = std::min(k + kBlock, lattice_.nodes[2]);
  for (std::uint32_t i = first; i < std::min(first + kBlock, lattice_.nodes[0]); ++i) {
    for (std::uint32_t y = j; y < j_end; ++y) {
      const Room* here = &building_.room_at(lattice_.at(i, y, k));
      if (here != room) {
        room = here;
        near_items_.clear();
        for (const Item& item : room->items)
          if (distance(item, centre) < 2 * reach + truncation_) near_items_.push_back(&item);
      }
      float* values = &slab_[(i - first) * lattice_.layer_size() + std::size_t{y} * lattice_.nodes[2]];
      for (std::uint32_t z = k; z < k_end; ++z) values[z] = value_at(i, y, z, *room, near_items_);
    }
  }
}

float Scan::value_at(std::uint32_t i, std::uint32_t j, std::uint32_t k, const Room& room,
                     std::span<const Item* const> items) {
  const Point p = lattice_.at(i, j, k);
  const double d = field(room, items, p);
  if (d < -truncation_ || d > 2 * truncation_) return kUnobserved;
  // Patches that were never looked at, larger where the view was poor.
  const double patches = 0.75 * smooth_noise(2.2 * p, seed_ + 1) + 0.35 * smooth_noise(9 * p, seed_ + 2);
  if (visibility_at(i, j, k) + patches < 0.42) return kUnobserved;
  const double drift = 0.2 * lattice_.voxel * smooth_noise(3 * p, seed_ + 3);
  const double grain = 0.06 * lattice_.voxel * place_noise(i, j, k, seed_ + 4);
  return static_cast<float>(std::min(d + drift + grain, truncation_));
}

/// Trilinear between the coarse nodes.
double Scan::visibility_at(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const std::array<std::uint32_t, 3> voxel{i - slab_first_, j, k};
  double sum = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<std::uint32_t, 3> node{};
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double share = (voxel[axis] % kCoarse) / static_cast<double>(kCoarse);
      const std::uint32_t up = corner >> axis & 1;
      node[axis] = voxel[axis] / kCoarse + up;
      weight *= up != 0 ? share : 1 - share;
    }
    if (weight != 0) sum += weight * visibility_node(node[0], node[1], node[2]);
  }
  return sum;
}

double Scan::visibility_node(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  float& known =
      visibility_[(std::size_t{a} * coarse_count(lattice_.nodes[1]) + b) * coarse_count(lattice_.nodes[2]) +
                  c];
  if (known < 0)
    known = static_cast<float>(
        trace_visibility(lattice_.at(slab_first_ + a * kCoarse, b * kCoarse, c * kCoarse)));
  return known;
}

/// How well the best of the room's viewpoints sees `p`, 0 to 1, by sphere tracing (Hart 1996). The first part
/// of the ray is free, for a place a little behind a surface is still updated by what is seen of it.
double Scan::trace_visibility(const Point& p) const {
  constexpr int kMaxSteps = 200;
  const Room& room = building_.room_at(p);
  double best = 0;
  for (const Point& viewpoint : room.viewpoints) {
    const Point ray = viewpoint - p;
    const double size = length(ray);
    const double value = 1 - 0.5 * (size / kRange) * (size / kRange);
    if (value <= best) continue;
    double t = 1.5 * truncation_;
    for (int step = 0; step < kMaxSteps && t < size; ++step) {
      const double d = field(room, p + (t / size) * ray);
      if (d < 0) break;
      t += std::max(d, 0.5 * lattice_.voxel);
    }
    if (t >= size) best = value;
  }
  return best;
}

}  // namespace deltamesh::scenes
