// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/settling.h"

#include <cmath>

namespace deltamesh::settling {
namespace {

/// Settled: what is still to come is small against the error that quantisation left (rms, largest). To come:
/// the last change times rate / (1 - rate), where every cycle changes `rate` times as much as the one before.
constexpr double kSettledRms = 0.03;
constexpr double kSettledLargest = 0.1;
constexpr double kLowestRate = 0.12;
constexpr double kHighestRate = 0.7;

/// Where more than this share of the vertices are anchors, coarse levels are nearly as large as the finest,
/// and slow errors may hide behind quick ones: no better rate is believed there.
constexpr double kManyAnchors = 0.05;
constexpr double kLowestRateOfMany = 0.5;

/// Rms that is small against the rounding of positions to floats, over their size.
constexpr double kInvisible = 0x1p-26;

/// Rms of the last change, over the error to expect, of a large component that is left as it is where
/// accelerated cycles hardly move it any more.
constexpr double kTolerated = 0.5;

/// Low-frequency error over rms of the anchors' forces, times share of anchors: 0.23 within 15 % on scans,
/// terrain and CAD, 4 to 8 bits, 0.1 to 2 % anchors.
constexpr double kErrorPerForce = 0.23;

/// The same where a vertex has more than kMostNeighbors: no vertex is far from an anchor there, and errors do
/// not add up on the way to one.
constexpr std::uint32_t kMostNeighbors = 64;
constexpr double kErrorPerForceWithHub = 0.02 * kErrorPerForce;

/// Bound of that estimate, over rms of the deltas: forces lie while cycles diverge.
constexpr double kMaxErrorPerDelta = 2;

double largest_coordinate(std::span<const Vec3> places) noexcept {
  double largest = 0;
  for (const Vec3& v : places)
    largest = std::max(largest, std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}));
  return largest;
}

bool has_hub(const Adjacency& graph) noexcept {
  for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
    if (graph.degree(v) > kMostNeighbors) return true;
  }
  return false;
}

bool has_many_anchors(const Progress& progress) noexcept {
  return static_cast<double>(progress.targets.size()) > kManyAnchors * static_cast<double>(progress.x.size());
}

}  // namespace

Settling::Settling(const Group& group)
    : group_(group),
      has_hub_(has_hub(*group.graph)),
      changes_(group.components.count),
      unsettled_(group.components.count) {}

double Settling::worst_change() const noexcept {
  double worst = 0;
  for (std::size_t c = 0; c < changes_.size(); ++c)
    worst = std::max(worst, std::sqrt(changes_[c].squares / group_.components.size[c]));
  return worst;
}

bool Settling::is_settled(double rate, const Progress& progress) {
  const double bounded =
      std::clamp(rate, has_many_anchors(progress) ? kLowestRateOfMany : kLowestRate, kHighestRate);
  const double extent = std::max(largest_coordinate(progress.targets), largest_coordinate(progress.x));
  const double error = std::max(expected_error(progress), kInvisible / kSettledRms * extent);
  const double change_allowed = (1 - bounded) / bounded * error;
  bool settled = true;
  for (std::size_t c = 0; c < changes_.size(); ++c) {
    const bool good =
        std::sqrt(changes_[c].squares / group_.components.size[c]) <= kSettledRms * change_allowed &&
        std::sqrt(changes_[c].largest) <= kSettledLargest * change_allowed;
    unsettled_[c] = good ? 0 : 1;  // NaN is not good
    settled = settled && good;
  }
  return settled;
}

void Settling::tolerate_large_components(const Progress& progress) {
  const double allowed = kTolerated * expected_error(progress);
  for (std::size_t c = 0; c < unsettled_.size(); ++c) {
    const double size = group_.components.size[c];
    if (size > kLargestRescue && changes_[c].squares <= allowed * allowed * size) unsettled_[c] = 0;
  }
}

/// Estimate of the rms error that quantisation leaves in the whole group.
double Settling::expected_error(const Progress& progress) const noexcept {
  double deltas = 0;
  for (std::size_t i = 0; i < progress.deltas.size(); ++i)
    deltas += dot(progress.deltas[i], progress.deltas[i]);
  deltas = std::sqrt(deltas / static_cast<double>(progress.deltas.size()));
  const double error = progress.targets.size() == group_.components.count ? error_of_lone_anchors(progress)
                                                                          : error_of_forces(progress);
  return std::clamp(error, 0.0, kMaxErrorPerDelta * deltas);
}

double Settling::error_of_forces(const Progress& progress) const noexcept {
  const auto anchors = static_cast<double>(progress.targets.size());
  double forces = 0;
  for (std::size_t a = 0; a < progress.targets.size(); ++a) {
    const Vec3 force = to_vec3(progress.cycles.force(a));
    forces += dot(force, force);
  }
  return (has_hub_ ? kErrorPerForceWithHub : kErrorPerForce) * std::sqrt(forces / anchors) *
         static_cast<double>(progress.x.size()) / anchors;
}

/// Forces tell nothing where every component has one anchor, but there s is constant: the mean of the
/// errors of its n deltas. Theirs is about sqrt(n) times as large, and the low-frequency error's as much
/// again, or more: 1.7 to 16 times the estimate, on scans, terrain and CAD.
double Settling::error_of_lone_anchors(const Progress& progress) const noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < progress.x.size(); ++i) {
    const Vec3 s = to_vec3(progress.cycles.solution()[i].s);
    const double size = group_.components.size[group_.components.label[i]];
    sum += size * size * dot(s, s);
  }
  return std::sqrt(sum / static_cast<double>(progress.x.size()));
}

}  // namespace deltamesh::settling
