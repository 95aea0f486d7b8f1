// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/memory/large_vector.h"
#include "base/simd/two_doubles.h"

namespace deltamesh {
namespace {

/// Edges count as at least this share of the diagonal, so that zero-length edges do not divide by zero.
constexpr double kShortestEdge = 1e-9;

/// Weighted sums over the edges at every vertex of a mesh, first lane, and of its decoded twin, second lane
/// (eqs. 1, 2).
class LaplacianPair {
 public:
  LaplacianPair(std::span<const Vec3> original, std::span<const Vec3> decoded)
      : original_(original), decoded_(decoded), shortest_(kShortestEdge * Box::around(original).diagonal()) {
    reserve_large(sums_, original.size());
    sums_.resize(original.size());
  }

  /// Every edge once, in either direction.
  void add_edge(std::uint32_t a, std::uint32_t b) noexcept {
    // With the vertex itself as origin the weighted sum does not lose digits to far-away coordinates.
    std::array<TwoDoubles, 3> edge;
    for (std::size_t axis = 0; axis < 3; ++axis)
      edge[axis] = TwoDoubles{original_[b][axis], decoded_[b][axis]} -
                   TwoDoubles{original_[a][axis], decoded_[a][axis]};
    const TwoDoubles squares = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
    const TwoDoubles length = larger_of(square_roots(squares), TwoDoubles{shortest_, shortest_});
    const TwoDoubles weight = 1.0 / length;
    // Where all is in one place.
    add(a, b, edge, shortest_ > 0 ? weight : TwoDoubles{or_one(weight[0]), or_one(weight[1])});
  }

  /// Sum over vertices with edges of the squared differences of S(v), and how many these are.
  struct Difference {
    double squares = 0;
    std::size_t vertices = 0;
  };
  Difference difference() const noexcept {
    Difference result;
    for (const Sums& sums : sums_) {
      if (!(sums.weights[0] > 0)) continue;
      const TwoDoubles scale = -1.0 / sums.weights;
      double square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const TwoDoubles laplacian = scale * sums.edges[axis];
        const double off = laplacian[0] - laplacian[1];
        square += off * off;
      }
      result.squares += square;
      ++result.vertices;
    }
    return result;
  }

 private:
  struct Sums {
    std::array<TwoDoubles, 3> edges{};
    TwoDoubles weights{};
  };

  static double or_one(double weight) noexcept { return std::isinf(weight) ? 1.0 : weight; }

  void add(std::uint32_t a, std::uint32_t b, const std::array<TwoDoubles, 3>& edge,
           TwoDoubles weight) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const TwoDoubles weighted = weight * edge[axis];
      sums_[a].edges[axis] += weighted;
      sums_[b].edges[axis] -= weighted;
    }
    sums_[a].weights += weight;
    sums_[b].weights += weight;
  }

  std::span<const Vec3> original_;
  std::span<const Vec3> decoded_;
  double shortest_;
  std::vector<Sums> sums_;
};

double root_mean(double squares, std::size_t count) noexcept {
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1)));
}

}  // namespace

Quality measure_quality(const Adjacency& graph, std::span<const Vec3> original,
                        std::span<const Vec3> decoded) {
  LaplacianPair laplacians(original, decoded);
  double positional = 0;  // M_q squared
  double largest = 0;
  for (std::uint32_t v = 0; v < original.size(); ++v) {
    const Vec3 error = original[v] - decoded[v];
    const double square = dot(error, error);
    largest = std::max(largest, square);
    if (graph.degree(v) == 0) continue;
    positional += square;
    const auto neighbors = graph.of(v);
    for (auto w = std::upper_bound(neighbors.begin(), neighbors.end(), v); w != neighbors.end(); ++w)
      laplacians.add_edge(v, *w);
  }
  const auto visual = laplacians.difference();
  return {.vde_rms = root_mean(visual.squares, visual.vertices),
          .lfe_rms = root_mean(positional, visual.vertices),
          .max_error = std::sqrt(largest)};
}

double measure_vde(const MeshEdges& edges, std::span<const Vec3> original, std::span<const Vec3> decoded) {
  LaplacianPair laplacians(original, decoded);
  edges.for_each([&](std::uint32_t a, std::uint32_t b) { laplacians.add_edge(a, b); });
  const auto visual = laplacians.difference();
  return root_mean(visual.squares, visual.vertices);
}

PaperQuality paper_form(const Quality& quality, std::uint64_t geometric_vertices, double diagonal) noexcept {
  if (!(diagonal > 0)) return {};
  const double scale = std::sqrt(static_cast<double>(geometric_vertices)) / diagonal;
  return {.vde = quality.vde_rms * scale, .lfe = quality.lfe_rms * scale};
}

}  // namespace deltamesh
