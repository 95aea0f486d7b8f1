// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "highpass/cycles/compensation.h"
#include "highpass/cycles/plan.h"
#include "highpass/highpass.h"
#include "highpass/symbols.h"
#include "laplacian/operator/delta.h"
#include "measure/measure.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

/// What an encoder may do to a mesh.
class Coding {
 public:
  Coding(GraphMesh mesh, int bits, std::uint32_t anchors, double diffusion = 0)
      : mesh_(std::move(mesh)),
        anchors_(mesh_.graph, mesh_.components),
        coder_(mesh_.graph, mesh_.components, anchors_, mesh_.positions, mesh_.box) {
    settings_.step = coder_.step_for_bits(bits);
    settings_.diffusion = diffusion;
    settings_.anchors = anchors;
  }

  Result<CodedHighpass> coded(int cycles) { return coder_.code(settings_, cycles); }
  Result<CodedHighpass> coded() { return coder_.code(settings_); }
  int fewest_cycles(double most_left_out) {
    const auto fewest = coder_.fewest_cycles(settings_, most_left_out);
    EXPECT_TRUE(fewest);
    return fewest ? *fewest : 0;
  }
  HighpassSettings& settings() { return settings_; }

  Result<LargeVector<Vec3>> read(const CodedHighpass& coded) const {
    return read_highpass(Payload::compact(coded.deltas), Payload::compact(coded.anchors), mesh_.graph,
                         mesh_.components, mesh_.box, coded.parameters);
  }
  Quality quality(const CodedHighpass& coded) const {
    return measure_quality(mesh_.graph, mesh_.positions, coded.positions);
  }
  const GraphMesh& mesh() const { return mesh_; }
  std::vector<std::uint32_t> anchors() { return coder_.anchors_for(settings_).vertices; }

 private:
  GraphMesh mesh_;
  HighpassSettings settings_;
  AnchorSequence anchors_;
  HighpassCoder coder_;
};

/// Errors of the exact least-squares solution of deltas and anchors that are rounded as the coder does it.
Quality exact_quality(Coding& coding, const HighpassSettings& settings) {
  const GraphMesh& mesh = coding.mesh();
  std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
  for (Vec3& delta : deltas) {
    for (double& x : delta) x = settings.step * std::round(x / settings.step);
  }
  const AnchorLattice lattice(mesh.box, settings.anchor_bits);
  const std::vector<std::uint32_t> anchors = coding.anchors();
  std::vector<Vec3> targets;
  for (const std::uint32_t anchor : anchors)
    targets.push_back(lattice.position_of(lattice.cell_of(mesh.positions[anchor])));
  std::vector<Vec3> x(deltas.size());
  test::DirectSolver(mesh.graph, anchors).solve(deltas, targets, x);
  return measure_quality(mesh.graph, mesh.positions, x);
}

TEST(HighpassCoder, DELT7FewCyclesAreAsGoodAsTheExactSolution) {
  for (const int bits : {6, 8, 12}) {
    SCOPED_TRACE(bits);
    Coding coding(test::sheet(90, 80), bits, 40);
    const auto coded = coding.coded();
    ASSERT_TRUE(coded);
    EXPECT_GE(coded->parameters.cycles, 1);
    EXPECT_LE(coded->parameters.cycles, 9);
    const Quality exact = exact_quality(coding, coding.settings());
    const Quality ours = coding.quality(*coded);
    EXPECT_LT(ours.lfe_rms, 1.04 * exact.lfe_rms);
    EXPECT_LT(ours.vde_rms, 1.02 * exact.vde_rms);
    EXPECT_LT(ours.max_error, 1.3 * exact.max_error);
    const auto decoded = coding.read(*coded);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(*decoded, coded->positions);
  }
}

/// With one anchor, few cycles miss low frequencies; around the hub of a fan, making up for what they miss
/// would move anchors out of the box.
TEST(HighpassCoder, DELT7CyclesAreTriedWithTheDeltasAndAnchorsThatAreCoded) {
  const auto lfe_over_exact = [](GraphMesh mesh, int bits, std::uint32_t anchors) {
    Coding coding(std::move(mesh), bits, anchors);
    const auto coded = coding.coded();
    EXPECT_TRUE(coded);
    return coded ? coding.quality(*coded).lfe_rms / exact_quality(coding, coding.settings()).lfe_rms : 1e9;
  };
  EXPECT_LT(lfe_over_exact(test::sheet(90, 80), 12, 1), 2);
  EXPECT_LT(lfe_over_exact(test::sheet(300, 3), 12, 1), 2);
  EXPECT_LT(lfe_over_exact(test::fan(3000), 14, 20), 2);
}

TEST(HighpassCoder, DELT7MoreCyclesWhereLittleMayBeLeftOut) {
  Coding coding(test::sheet(90, 80), 8, 40);
  const int few = coding.fewest_cycles(std::numeric_limits<double>::infinity());
  const int more = coding.fewest_cycles(1e-4);
  EXPECT_GT(more, few);
  EXPECT_LT(more, 16);
}

/// Errors stay where they are, but for those that the anchors mend.
TEST(HighpassCoder, MoreAnchorsLeaveTheDeltasAsTheyAre) {
  for (const double diffusion : {0.0, 1.0}) {
    Coding coding(test::sheet(90, 80), 8, 40, diffusion);
    const auto before = coding.coded(8);
    ASSERT_TRUE(before);
    coding.settings().more_anchors = {777, 3000};
    const auto after = coding.coded(8);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->deltas, before->deltas);
    EXPECT_EQ(after->parameters.anchors, before->parameters.anchors + 2);
    EXPECT_LT(coding.quality(*after).lfe_rms, coding.quality(*before).lfe_rms);
    const auto decoded = coding.read(*after);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(*decoded, after->positions);
  }
}

constexpr Box kEverywhere{{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}};

/// One cycle leaves out several times the error of quantisation; two steps of compensation make up for it.
TEST(Compensation, DELT7CyclesGiveThePositionsBackThatItIsFor) {
  Coding coding(test::sheet(90, 80), 8, 30);
  const GraphMesh& mesh = coding.mesh();
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  const Vec3 center = middle(mesh.box);
  const std::vector<std::uint32_t> anchors = anchor_rows(coding.anchors(), part);
  for (const int cycles : {1, 2, 3}) {
    SCOPED_TRACE(cycles);
    PlannedSolver solver(part.graph, part.components);
    Compensation source(part, mesh.positions, center, kEverywhere);
    const auto error_of_cycles = [&] {
      std::vector<Vec3> targets, x(part.row_count);
      for (const std::uint32_t row : anchors)
        targets.push_back(source.positions()[part.vertex(row)] - center);
      const std::vector<Vec3> deltas(source.deltas().begin(), source.deltas().end());
      EXPECT_TRUE(solver.solve(anchors, deltas, targets, cycles, x));
      double squares = 0;
      for (std::size_t row = 0; row < x.size(); ++row) {
        const Vec3 error = mesh.positions[part.vertex(row)] - (center + x[row]);
        squares += dot(error, error);
      }
      return std::sqrt(squares / static_cast<double>(x.size()));
    };
    const double before = error_of_cycles();
    ASSERT_TRUE(source.improve(solver, anchors, cycles));
    const double once = error_of_cycles();
    ASSERT_TRUE(source.improve(solver, anchors, cycles));
    const double twice = error_of_cycles();
    EXPECT_LT(once, 0.11 * before);
    EXPECT_LT(twice, 0.016 * before);
  }
}

TEST(HighpassCoder, DELT7SizeMakesNoDifference) {
  int cycles = 0;
  for (const double size : {1.0, 0x1p80, 0x1p-80}) {
    SCOPED_TRACE(size);
    GraphMesh mesh = test::sheet(60, 50);
    for (Vec3& position : mesh.positions) position = size * position;
    Coding coding(test::finish(std::move(mesh)), 8, 20);
    const auto coded = coding.coded();
    ASSERT_TRUE(coded);
    if (cycles == 0) cycles = coded->parameters.cycles;
    EXPECT_EQ(coded->parameters.cycles, cycles);
  }
}

TEST(HighpassCoder, OneCycleWhereNothingIsSolvedByCycles) {
  for (GraphMesh mesh : {test::sheet(1, 1), test::fragments()}) {
    Coding coding(std::move(mesh), 8, 1);
    const auto coded = coding.coded();
    ASSERT_TRUE(coded);
    EXPECT_EQ(coded->parameters.cycles, 1);
  }
}

TEST(Compensation, StartsFromThePositionsThemselves) {
  const GraphMesh mesh = test::fragments();
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  const Compensation source(part, mesh.positions, middle(mesh.box), kEverywhere);
  EXPECT_TRUE(std::equal(source.positions().begin(), source.positions().end(), mesh.positions.begin(),
                         mesh.positions.end()));
  const auto deltas = delta_coordinates(part, mesh.positions);
  EXPECT_TRUE(std::equal(source.deltas().begin(), source.deltas().end(), deltas.begin(), deltas.end()));
}

TEST(FlatDeltas, LoseWhatIsLeftOutWhereAllAroundIsZero) {
  const GraphMesh mesh = test::sheet(20, 9);
  const std::size_t count = mesh.positions.size();
  const double all = std::sqrt(static_cast<double>(count));
  std::vector<std::int32_t> symbols(3 * count, 0);
  std::vector<Vec3> change(count, Vec3{});
  change[60] = {0.5, 0.25, 0};
  const auto square = [](double x) { return x * x; };
  // L of the change: itself, and its share in the mean of each neighbour.
  double shares = 1;
  for (const std::uint32_t neighbor : mesh.graph.of(60)) shares += square(1.0 / mesh.graph.degree(neighbor));
  const double of_x = 0.5 * std::sqrt(shares) / all;
  EXPECT_DOUBLE_EQ(FlatDeltas(mesh.graph, symbols).left_out(change).lost, std::hypot(of_x, 0.5 * of_x));
  EXPECT_DOUBLE_EQ(FlatDeltas(mesh.graph, symbols).left_out(change).largest, std::hypot(0.5, 0.25));
  symbols[60] = 1;  // of x, there and around
  EXPECT_DOUBLE_EQ(FlatDeltas(mesh.graph, symbols).left_out(change).lost, 0.5 * of_x);
  symbols[count + 60] = -1;
  EXPECT_EQ(FlatDeltas(mesh.graph, symbols).left_out(change).lost, 0);
}

TEST(PlanErrors, AreFairWhereHardlyLarger) {
  const GraphMesh mesh = test::sheet(12, 9);
  const auto of = [&](double all, double one) {
    std::vector<Vec3> positions = mesh.positions;
    for (Vec3& position : positions) position[0] += all;
    positions[30][1] += one;
    for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = positions[v] - mesh.positions[v];
    return errors_of(mesh.graph, positions);
  };
  const PlanErrors best = of(0.5, 1.5);
  EXPECT_DOUBLE_EQ(best.largest, std::sqrt(0.25 + 2.25));
  EXPECT_TRUE(best.are_fair(best, 1e-9));
  const PlanErrors twice = of(1, 3);
  EXPECT_NEAR(twice.rms, 2 * best.rms, 1e-12);
  EXPECT_NEAR(twice.roughness, 2 * best.roughness, 1e-12);
  EXPECT_FALSE(twice.are_fair(best, 1e-9));
  EXPECT_TRUE(twice.are_fair(best, 10)) << "nobody sees that";
  EXPECT_FALSE(of(0.6, 1.5).are_fair(best, 1e-9)) << "no rougher, but farther away";
  EXPECT_TRUE(of(0, 0).are_fair(best, 1e-9));
  EXPECT_FALSE(of(0, std::numeric_limits<double>::quiet_NaN()).are_fair(best, 1e-9));
}

}  // namespace
}  // namespace deltamesh
