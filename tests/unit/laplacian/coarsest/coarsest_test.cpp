// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/coarsest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "laplacian/coarsest/conjugate_gradients.h"
#include "laplacian/coarsest/envelope_factor.h"
#include "laplacian/multigrid/setup/levels.h"
#include "support/graph_mesh.h"
#include "support/random.h"
#include "unit/laplacian/finest_level.h"

namespace deltamesh::coarsest_test {
namespace {

using multigrid::ConjugateGradients;
using multigrid::Double4;
using multigrid::EnvelopeFactor;
using multigrid::Float4;
using multigrid::Level;
using multigrid::Row;
using test::GraphMesh;

std::vector<std::uint32_t> every(std::uint32_t stride, const GraphMesh& mesh) {
  std::vector<std::uint32_t> anchors;
  for (std::uint32_t v = 0; v < mesh.positions.size(); v += stride) anchors.push_back(v);
  return anchors;
}

std::vector<double> inverse_mass_of(const Level& level) {
  std::vector<double> result;
  for (const float mass : level.mass) result.push_back(1 / static_cast<double>(mass));
  return result;
}

/// From -1 to 1, on three axes.
std::vector<Double4> noise(std::size_t count, std::uint32_t seed) {
  test::RandomBits random(seed);
  const auto next = [&] { return std::ldexp(static_cast<double>(random()), -31) - 1; };
  std::vector<Double4> result(count);
  for (Double4& v : result) {
    v.xy = TwoDoubles{next(), next()};
    v.zw = TwoDoubles{next(), 0};
  }
  return result;
}

std::vector<double> times_k(const Level& level, const std::vector<double>& v) {
  std::vector<double> result(v.size());
  for (std::uint32_t i = 0; i < v.size(); ++i) {
    result[i] = static_cast<double>(level.degree[i]) * v[i];
    for (std::uint32_t e = level.offsets[i]; e < level.offsets[i + 1]; ++e)
      result[i] -= static_cast<double>(level.weights[e]) * v[level.neighbors[e]];
  }
  return result;
}

/// N v = (K M^-1 K + E E^T) v.
std::vector<double> times_n(const Level& level, const std::vector<double>& v) {
  std::vector<double> result = times_k(level, v);
  for (std::size_t i = 0; i < v.size(); ++i) result[i] /= static_cast<double>(level.mass[i]);
  result = times_k(level, result);
  for (const std::uint32_t anchor : level.anchors) result[anchor] += v[anchor];
  return result;
}

double lane(const Double4& v, std::size_t axis) { return axis < 2 ? v.xy[axis] : v.zw[axis - 2]; }

std::vector<double> axis_of(std::span<const Double4> values, std::size_t axis) {
  std::vector<double> result;
  for (const Double4& v : values) result.push_back(lane(v, axis));
  return result;
}

/// Root mean square of N x - b over that of b, on one axis.
double residual(const Level& level, std::span<const Double4> x, std::span<const Double4> b,
                std::size_t axis) {
  const std::vector<double> image = times_n(level, axis_of(x, axis));
  double left = 0;
  double all = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double wanted = lane(b[i], axis);
    left += (image[i] - wanted) * (image[i] - wanted);
    all += wanted * wanted;
  }
  return std::sqrt(left / all);
}

/// Two chains, of the even nodes and of the odd ones, numbered to and fro, and a node alone.
TEST(NarrowOrder, NeighborsAreNext) {
  const std::vector<std::uint32_t> chains[] = {{4, 0, 8, 2, 6}, {1, 7, 3, 5}};
  std::vector<std::vector<std::uint32_t>> around(10);
  for (const auto& chain : chains) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      around[chain[i]].push_back(chain[i + 1]);
      around[chain[i + 1]].push_back(chain[i]);
    }
  }
  std::vector<std::uint32_t> offsets(1);
  std::vector<std::uint32_t> neighbors;
  for (const auto& row : around) {
    neighbors.insert(neighbors.end(), row.begin(), row.end());
    offsets.push_back(static_cast<std::uint32_t>(neighbors.size()));
  }
  Level level;
  level.offsets = offsets;
  level.neighbors = neighbors;
  std::vector<std::uint32_t> nodes{3, 3, 3};  // no matter
  multigrid::order_narrowly(level, nodes);
  std::vector<std::uint32_t> sorted = nodes;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  const auto place = [&](std::uint32_t node) {
    return std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
  };
  for (std::uint32_t node = 0; node < around.size(); ++node)
    for (const std::uint32_t neighbor : around[node]) EXPECT_EQ(std::abs(place(node) - place(neighbor)), 1);
}

TEST(EnvelopeFactor, SolvesExactly) {
  const GraphMesh mesh = test::sheet(14, 13);
  for (const std::uint32_t stride : {1U, 7U, 500U}) {
    const Level level = test::finest_level(mesh, every(stride, mesh));
    EnvelopeFactor factor;
    factor.factor(test::finest_level(test::fan(40), {0}));  // no matter
    factor.factor(level);
    const std::vector<Double4> b = noise(level.node_count(), 3);
    std::vector<Double4> x = b;
    factor.solve(x);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LT(residual(level, x, b, axis), 1e-8) << stride;
    for (const Double4& v : x) EXPECT_EQ(v.zw[1], 0);
  }
}

/// Nodes 0 and 1 have an edge, node 0 is an anchor, node 2 has nothing: N = (3 -2 0, -2 2 0, 0 0 0).
TEST(EnvelopeFactor, APivotOfZeroGivesZero) {
  const std::array<std::uint32_t, 4> offsets{0, 1, 2, 2};
  const std::array<std::uint32_t, 2> neighbors{1, 0};
  Level level;
  level.offsets = offsets;
  level.neighbors = neighbors;
  level.weights.assign(2, 1.0F);
  for (const float degree : {1.0F, 1.0F, 0.0F}) level.degree.push_back(degree);
  level.mass.assign(3, 1.0F);
  level.anchors = {0};
  std::vector<Double4> x(3);
  x[0].xy = TwoDoubles{1, 0};
  x[2].xy = TwoDoubles{5, 0};
  EnvelopeFactor factor;
  factor.factor(level);
  factor.solve(x);
  EXPECT_NEAR(x[0].xy[0], 1, 1e-12);
  EXPECT_NEAR(x[1].xy[0], 1, 1e-12);
  EXPECT_EQ(x[2].xy[0], 0);
}

/// As many anchors as coarsest levels have.
TEST(ConjugateGradients, ComeNearTheSolutionWhereAnchorsAreMany) {
  for (const GraphMesh& mesh : {test::sheet(40, 30), test::sheet(300, 4)}) {
    const Level level = test::finest_level(mesh, every(5, mesh));
    ConjugateGradients solver(level, inverse_mass_of(level));
    const std::vector<Double4> b = noise(level.node_count(), 4);
    std::vector<Double4> x = b;
    solver.solve(x);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LT(residual(level, x, b, axis), 0.05);
  }
}

TEST(ConjugateGradients, AxesDoNotMix) {
  const GraphMesh mesh = test::sheet(25, 20);
  const Level level = test::finest_level(mesh, every(5, mesh));
  ConjugateGradients solver(level, inverse_mass_of(level));
  std::vector<Double4> all = noise(level.node_count(), 5);
  std::vector<Double4> one = all;
  for (Double4& v : one) {
    v.xy[1] = 0;
    v.zw[0] *= 4;
  }
  solver.solve(all);
  solver.solve(one);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(one[i].xy[0], all[i].xy[0]);
    EXPECT_EQ(one[i].xy[1], 0);
    EXPECT_EQ(one[i].zw[0], 4 * all[i].zw[0]);
  }
}

/// Right-hand sides and solution of a level.
struct Coupled {
  std::vector<Row> b;
  std::vector<Row> u;
  std::vector<Float4> gaps;
  std::vector<Float4> forces;

  multigrid::CoupledProblem on(const Level& level) { return {level, b, u, gaps, forces}; }
};

Float4 to_floats(const Double4& v) { return multigrid::narrow(v); }

Coupled random_problem(const Level& level) {
  Coupled problem;
  const std::size_t n = level.node_count();
  const std::vector<Double4> values = noise(2 * n + level.anchors.size(), 7);
  for (std::size_t i = 0; i < n; ++i) problem.b.push_back({to_floats(values[i]), to_floats(values[n + i])});
  for (std::size_t a = 0; a < level.anchors.size(); ++a) problem.gaps.push_back(to_floats(values[2 * n + a]));
  problem.u.resize(n);
  problem.forces.resize(level.anchors.size());
  return problem;
}

/// The largest difference of the two sides of any equation: K x + M s = b.x,  K s - E f = b.s,  x_a - f_a =
/// g_a.
struct Differences {
  double of_x = 0;
  double of_s = 0;
  double of_gaps = 0;
};

Differences differences(const Level& level, const Coupled& problem) {
  Differences found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> x;
    std::vector<double> s;
    for (const Row& u : problem.u) {
      x.push_back(u.x[axis]);
      s.push_back(u.s[axis]);
    }
    const std::vector<double> kx = times_k(level, x);
    std::vector<double> ks = times_k(level, s);
    for (std::size_t a = 0; a < level.anchors.size(); ++a) {
      const std::uint32_t anchor = level.anchors[a];
      const double force = problem.forces[a][axis];
      ks[anchor] -= force;
      found.of_gaps = std::max(found.of_gaps, std::abs(x[anchor] - force - problem.gaps[a][axis]));
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double mass = level.mass[i];
      found.of_x = std::max(found.of_x, std::abs(kx[i] + mass * s[i] - problem.b[i].x[axis]));
      found.of_s = std::max(found.of_s, std::abs(ks[i] - problem.b[i].s[axis]));
    }
  }
  return found;
}

/// A finest level without arrays of its own, as decoders have it.
TEST(SolveDirectly, DELT6DELT7IsTheLeastSquaresSolution) {
  EnvelopeFactor factor;
  for (const GraphMesh& mesh : {test::sheet(14, 13), test::sheet(60, 2), test::fan(90)}) {
    const std::vector<std::uint32_t> anchors = every(31, mesh);
    std::vector<Vec3> deltas(mesh.positions.size());
    for (std::size_t i = 0; i < deltas.size(); ++i)
      deltas[i] = {i % 3 == 0 ? 0.1 : 0.0, i % 5 == 0 ? 0.2 : -0.1, -0.3};
    std::vector<Vec3> targets;
    for (const std::uint32_t anchor : anchors) targets.push_back(mesh.positions[anchor]);
    std::vector<Vec3> exact(deltas.size()), x(deltas.size());
    test::DirectSolver(mesh.graph, anchors).solve(deltas, targets, exact);
    multigrid::solve_directly(multigrid::finest_level(mesh.graph, anchors), deltas, targets, factor, x);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT(length(x[i] - exact[i]), 1e-6);
  }
}

TEST(CoarsestSolver, DELT7SmallLevelsAreSolvedExactly) {
  const GraphMesh mesh = test::sheet(14, 13);
  ASSERT_LT(mesh.positions.size(), multigrid::kFewestNodesToCoarsen);
  const Level level = test::finest_level(mesh, every(9, mesh));
  multigrid::CoarsestSolver solver(level);
  Coupled problem = random_problem(level);
  solver.solve(problem.on(level));
  const Differences found = differences(level, problem);
  EXPECT_LT(found.of_x, 1e-3);
  EXPECT_LT(found.of_s, 1e-3);
  EXPECT_LT(found.of_gaps, 1e-5);
}

TEST(CoarsestSolver, DELT7LargerLevelsAreSolvedNearly) {
  const GraphMesh mesh = test::sheet(25, 20);
  ASSERT_GE(mesh.positions.size(), multigrid::kFewestNodesToCoarsen);
  const Level level = test::finest_level(mesh, every(5, mesh));
  multigrid::CoarsestSolver solver(level);
  Coupled problem = random_problem(level);
  solver.solve(problem.on(level));
  const Differences found = differences(level, problem);
  EXPECT_LT(found.of_x, 1e-3) << "s follows from x";
  EXPECT_LT(found.of_s, 0.1);
  EXPECT_LT(found.of_gaps, 1e-5);
}

TEST(CoarsestSolver, DELT7AnAnchorThatIsTheOnlyOneHasNoForce) {
  const GraphMesh mesh = test::sheet(12, 12);
  const Level level = test::finest_level(mesh, {70});
  multigrid::CoarsestSolver solver(level);
  Coupled problem = random_problem(level);
  problem.forces[0] = Float4{1, 2, 3, 4};
  solver.solve(problem.on(level));
  for (std::size_t axis = 0; axis < 4; ++axis) EXPECT_EQ(problem.forces[0][axis], 0);
}

TEST(CoarsestSolver, SolutionsDoNotDependOnEarlierOnes) {
  for (const GraphMesh& mesh : {test::sheet(12, 12), test::sheet(25, 20)}) {
    const Level level = test::finest_level(mesh, every(5, mesh));
    multigrid::CoarsestSolver solver(level);
    Coupled first = random_problem(level);
    Coupled other = first;
    for (Row& b : other.b) b.x = b.x + 1;
    Coupled again = first;
    solver.solve(first.on(level));
    solver.solve(other.on(level));
    solver.solve(again.on(level));
    for (std::size_t i = 0; i < first.u.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(first.u[i].x[axis], again.u[i].x[axis]);
        EXPECT_EQ(first.u[i].s[axis], again.u[i].s[axis]);
      }
    }
  }
}

}  // namespace
}  // namespace deltamesh::coarsest_test
