// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "attributes/error.h"
#include "attributes/normals/lattice.h"
#include "attributes/normals/normals.h"
#include "attributes/normals/prediction.h"
#include "attributes/normals/traversal.h"
#include "base/byte_writer.h"
#include "base/memory/large_vector.h"
#include "base/numbers/portable_math.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// The largest distance of unit vectors, at the bound in use.
struct NormalBound {
  double chord;  ///< of the whole bound
  double same;   ///< at most this far apart normals are one
};

/// The source of a NormalTraversal that writes.
class NormalChoice {
 public:
  /// `normals`: n x 3.
  NormalChoice(std::span<const float> normals, const NormalBound& bound, const NormalLattice& lattice)
      : bound_(bound), lattice_(lattice) {
    reserve_large(originals_, normals.size() / 3);
    for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
      Vec3 normal = widen(normals.subspan(i));
      normalize(normal);
      originals_.push_back(normal);
    }
  }

  /// Unit length or 0.
  const Vec3& original(std::uint32_t v) const noexcept { return originals_[v]; }

  bool is_zero(std::uint32_t v) const noexcept { return original(v) == Vec3{}; }
  bool same(std::uint32_t v, std::uint32_t u) const noexcept {
    if (is_zero(v) != is_zero(u)) return false;
    const Vec3 off = original(v) - original(u);
    return dot(off, off) <= bound_.same * bound_.same;
  }

  /// Of the lattice points within the bound of all `vertices`, which are same(), the one nearest to the
  /// prediction.
  LatticePoint choose(const NormalPrediction& prediction, std::span<const std::uint32_t> vertices) const {
    const auto x = point_of(prediction.frame, original(vertices[0]));
    const double square = x[0] * x[0] + x[1] * x[1];
    // Further out the lattice is narrower on the sphere.
    const double reach = lattice_.radius() * (1 + std::fmin(square, 1)) * 1.0001;
    const double rows = lattice_.row_distance();
    const double places = lattice_.place_distance();
    LatticePoint best;
    double best_square = std::numeric_limits<double>::infinity();
    const auto last_row = static_cast<std::int32_t>(std::floor((x[0] + reach) / rows));
    for (auto row = static_cast<std::int32_t>(std::ceil((x[0] - reach) / rows)); row <= last_row; ++row) {
      const double off = x[0] - rows * row;
      const double width = std::sqrt(std::fmax(0, reach * reach - off * off));
      const double shift = (row & 1) != 0 ? 0.5 : 0.0;
      const auto last = static_cast<std::int32_t>(std::floor((x[1] + width) / places - shift));
      for (auto place = static_cast<std::int32_t>(std::ceil((x[1] - width) / places - shift)); place <= last;
           ++place) {
        const LatticePoint point{row, place};
        const auto at = lattice_.at(point);
        const double from_pole = static_cast<double>(at[0] * at[0] + at[1] * at[1]);
        if (from_pole >= best_square || !fits(prediction, point, vertices)) continue;
        best_square = from_pole;
        best = point;
      }
    }
    return best;
  }

 private:
  bool fits(const NormalPrediction& prediction, const LatticePoint& point,
            std::span<const std::uint32_t> vertices) const {
    FourFloats direction{};
    if (!direction_at(prediction.frame, lattice_.at(point), direction)) return false;
    Vec3 decoded = widen(direction);
    normalize(decoded);
    return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
      const Vec3 off = decoded - original(v);
      return dot(off, off) <= bound_.chord * bound_.chord;
    });
  }

  std::vector<Vec3> originals_;
  NormalBound bound_;
  NormalLattice lattice_;
};

/// Part of the bound up to which the normals of copies count as one.
constexpr double kSamePart = 1.0 / 256;

/// A rule whose normals are so often within the bound predicts better alone: what is blended with decoded
/// neighbours drifts off within the bound.
constexpr double kSureRule = 0.98;

/// A rule is judged by about so many vertices.
constexpr std::uint32_t kMostFitted = 512;

/// What arithmetic in f32 may add to a distance.
constexpr double kRounding = 1e-6;

bool are_directions(std::span<const float> normals, NormalParameters& parameters) {
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const Vec3 normal = widen(normals.subspan(i));
    if (normal == Vec3{}) {
      parameters.has_zeros = true;
    } else if (!is_direction(normal)) {
      return false;
    }
  }
  return true;
}

bool any_same(const NormalChoice& choice, const AttributeSurface& surface) {
  for (std::uint32_t v = 1; v < surface.vertex_count(); ++v) {
    for (std::uint32_t u = v; u > 0 && surface.geometric_of(u - 1) == surface.geometric_of(v) && v - u < 8;
         --u)
      if (choice.same(v, u - 1)) return true;
  }
  return false;
}

/// How a rule's normals compare with the originals.
struct RuleFit {
  NormalRule rule = NormalRule::kNone;
  double bits = 0;    ///< what the distances would cost, about
  double within = 0;  ///< part of the vertices within the bound
};

/// Some of the vertices, the first of their copies, and the faces around these.
struct RuleSample {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> triangles;
};

RuleSample sample_surface(const AttributeSurface& surface) {
  RuleSample sample;
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t v = 0; v < surface.vertex_count(); v = surface.copies_end(v)) firsts.push_back(v);
  for (std::size_t i = 0; i < firsts.size(); i += firsts.size() / kMostFitted + 1)
    sample.vertices.push_back(firsts[i]);

  std::vector<std::uint32_t> faces;
  for (const std::uint32_t first : sample.vertices)
    for (std::uint32_t v = first, end = surface.copies_end(first); v < end; ++v)
      for (const Corner& corner : surface.corners().of(v)) faces.push_back(corner.face);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  for (const std::uint32_t f : faces)
    for (const std::uint32_t v : surface.triangles().subspan(3 * std::size_t{f}, 3))
      sample.triangles.push_back(v);
  return sample;
}

RuleFit fit_rule(NormalRule rule, const RuleSample& sample, const NormalChoice& choice,
                 const AttributeSurface& surface, double radius) {
  RuleFit fit{.rule = rule};
  const auto sums = sum_by_rule(rule, sample.triangles, surface.positions());
  for (const std::uint32_t first : sample.vertices) {
    RuleSum sum{};
    for (std::uint32_t v = first, end = surface.copies_end(first); v < end; ++v)
      if (v == first || choice.same(v, first)) sum += sums[v];
    Vec3 normal = widen(sum);
    if (!(normalize(normal) > 0)) continue;
    const Vec3 off = normal - choice.original(first);
    const double square = dot(off, off) / (4 * radius * radius);
    fit.within += square <= 1 ? 1.0 / static_cast<double>(sample.vertices.size()) : 0;
    fit.bits += portable_log2(0.1 + square);
  }
  return fit;
}

/// The rule that comes nearest.
RuleFit find_rule(const NormalChoice& choice, const AttributeSurface& surface, double radius) {
  if (!surface.has_positions()) return {};
  const RuleSample sample = sample_surface(surface);
  RuleFit best{.bits = std::numeric_limits<double>::infinity()};
  for (const NormalRule rule : {NormalRule::kAngle, NormalRule::kArea, NormalRule::kPlain,
                                NormalRule::kAreaAngle, NormalRule::kEdges}) {
    const RuleFit fit = fit_rule(rule, sample, choice, surface, radius);
    if (fit.bits < best.bits) best = fit;
  }
  return best;
}

}  // namespace

std::optional<CodedValues<float>> write_surface_normals(std::span<const float> normals, double max_degrees,
                                                        const AttributeSurface& surface) {
  NormalParameters parameters;
  if (!(max_degrees >= kLeastAngle && max_degrees <= kMostAngle)) return std::nullopt;
  if (normals.size() != 3 * std::size_t{surface.vertex_count()}) return std::nullopt;
  if (!are_directions(normals, parameters)) return std::nullopt;

  const double chord = chord_of(max_degrees);
  const NormalBound bound{.chord = chord * (1 - 1e-6), .same = chord * kSamePart};
  parameters.radius = static_cast<float>(0.5 * (chord * (1 - kSamePart - 2e-6) - kRounding));
  NormalChoice choice(normals, bound, NormalLattice(parameters.radius));
  parameters.shares = any_same(choice, surface);
  const RuleFit fit = find_rule(choice, surface, static_cast<double>(parameters.radius));
  parameters.rule = fit.rule;
  parameters.blends = fit.rule != NormalRule::kNone && fit.within < kSureRule;

  CompactWriter writer;
  NormalTraversal traversal(writer, choice, surface, parameters);
  if (!traversal.run()) return std::nullopt;
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(
      static_cast<int>(parameters.rule) | (parameters.shares ? kSharesFlag : 0) |
      (parameters.has_zeros ? kZerosFlag : 0) | (parameters.blends ? kBlendsFlag : 0)));
  out.write(parameters.radius);
  out.write_bytes(writer.finish());
  return CodedValues<float>{.bytes = out.take(), .values = traversal.values()};
}

}  // namespace deltamesh
