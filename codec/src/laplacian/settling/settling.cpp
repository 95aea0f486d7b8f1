// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/settling.h"

#include <algorithm>
#include <cmath>

namespace deltamesh {
namespace {

/// Settled: what is still to come is small against the error that quantisation left (rms, largest). To come:
/// the last change times rate / (1 - rate), where every step changes `rate` times as much as the one before.
constexpr double kSettledRms = 0.05;
constexpr double kSettledLargest = 0.15;
constexpr double kLowestRate = 0.12;
constexpr double kHighestRate = 0.99;

/// Rms that is small against the rounding of positions to floats, over their size.
constexpr double kInvisible = 0x1p-26;

/// Low-frequency error over rms of the anchors' forces, times share of anchors: 0.23 within 15 % on scans,
/// terrain and CAD, 4 to 8 bits, 0.1 to 2 % anchors.
constexpr double kErrorPerForce = 0.23;

/// The same where a vertex has more than kMostNeighbors: no vertex is far from an anchor there, and errors do
/// not add up on the way to one.
constexpr std::uint32_t kMostNeighbors = 64;
constexpr double kErrorPerForceWithHub = 0.02 * kErrorPerForce;

/// Bound of that estimate, over rms of the deltas: forces lie while steps diverge.
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

double rms_of(const DeltaView& deltas) noexcept {
  double squares = 0;
  for (std::size_t i = 0; i < deltas.size(); ++i) squares += dot(deltas[i], deltas[i]);
  return std::sqrt(squares / static_cast<double>(deltas.size()));
}

}  // namespace

std::vector<Change> measure(const Components& components, std::span<const Vec3> change) {
  std::vector<Change> changes(components.count);
  for (std::size_t i = 0; i < change.size(); ++i) {
    const double square = dot(change[i], change[i]);
    Change& own = changes[components.label[i]];
    own.squares += square;
    own.largest = std::max(own.largest, square);
  }
  return changes;
}

Settling::Settling(const Adjacency& graph, const Components& components, const DeltaView& deltas,
                   std::span<const Vec3> targets)
    : graph_(graph),
      components_(components),
      targets_(targets),
      has_hub_(has_hub(graph)),
      delta_rms_(rms_of(deltas)) {}

double Settling::worst(std::span<const Change> changes) const noexcept {
  double worst = 0;
  for (std::size_t c = 0; c < components_.count; ++c)
    worst = std::max(worst, std::sqrt(changes[c].squares / components_.size[c]));
  return worst;
}

bool Settling::is_settled(std::span<const Change> changes, double rate, const Steps& steps,
                          std::span<const Vec3> x) const {
  const double bounded = rate > kLowestRate ? std::min(rate, kHighestRate) : kLowestRate;  // also 0 / 0
  const double extent = std::max(largest_coordinate(targets_), largest_coordinate(x));
  const double error = std::max(expected_error(steps), kInvisible / kSettledRms * extent);
  const double change_allowed = (1 - bounded) / bounded * error;
  for (std::size_t c = 0; c < components_.count; ++c) {
    const Change& change = changes[c];
    const bool good = std::sqrt(change.squares / components_.size[c]) <= kSettledRms * change_allowed &&
                      std::sqrt(change.largest) <= kSettledLargest * change_allowed;
    if (!good) return false;  // NaN is not good
  }
  return true;
}

/// Estimate of the rms error that quantisation leaves in all components together.
double Settling::expected_error(const Steps& steps) const noexcept {
  const bool have_one_each = targets_.size() == components_.count;
  const double error = have_one_each ? error_of_lone_anchors(steps) : error_of_forces(steps);
  return std::clamp(error, 0.0, kMaxErrorPerDelta * delta_rms_);
}

double Settling::error_of_forces(const Steps& steps) const noexcept {
  const auto anchors = static_cast<double>(targets_.size());
  double forces = 0;
  for (const Vec3& gap : steps.gaps()) forces += dot(gap, gap);
  return (has_hub_ ? kErrorPerForceWithHub : kErrorPerForce) * std::sqrt(forces / anchors) *
         static_cast<double>(graph_.vertex_count()) / anchors;
}

/// Forces tell nothing where every component has one anchor, but there s is constant: the mean of the
/// errors of its n deltas. Theirs is about sqrt(n) times as large, and the low-frequency error's as much
/// again, or more: 1.7 to 16 times the estimate, on scans, terrain and CAD.
double Settling::error_of_lone_anchors(const Steps& steps) const noexcept {
  double sum = 0;
  for (std::uint32_t i = 0; i < graph_.vertex_count(); ++i) {
    const double factor = components_.size[components_.label[i]] / static_cast<double>(graph_.degree(i));
    sum += factor * factor * dot(steps.residual()[i], steps.residual()[i]);
  }
  return std::sqrt(sum / static_cast<double>(graph_.vertex_count()));
}

}  // namespace deltamesh
