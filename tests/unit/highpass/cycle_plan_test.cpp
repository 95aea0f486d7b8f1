// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/cycle_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

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

  Result<CodedHighpass> settled() { return coder_.code(settings_); }
  Result<CodedHighpass> planned(int cycles) { return coder_.code_planned(settings_, cycles); }
  template <class Accepts>
  std::optional<CodedHighpass> plan(const CodedHighpass& settled, const Accepts& accepts) {
    return coder_.plan(settings_, settled.positions, accepts);
  }

  Result<LargeVector<Vec3>> read(const CodedHighpass& coded) const {
    return read_highpass(coded.deltas, coded.anchors, mesh_.graph, mesh_.components, mesh_.box,
                         coded.parameters);
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

bool always(const CodedHighpass&) { return true; }

/// Root mean square of the distances.
double errors_apart(const CodedHighpass& a, const CodedHighpass& b) {
  double squares = 0;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    const Vec3 difference = a.positions[v] - b.positions[v];
    squares += dot(difference, difference);
  }
  return std::sqrt(squares / static_cast<double>(a.positions.size()));
}

TEST(CyclePlan, DELT7PlansAreAsGoodAsSettledStreams) {
  for (const int bits : {6, 8, 12}) {
    for (const double diffusion : {0.0, 1.0}) {
      SCOPED_TRACE(testing::Message() << bits << " bits, diffusion " << diffusion);
      Coding coding(test::sheet(90, 80), bits, 40, diffusion);
      const auto settled = coding.settled();
      ASSERT_TRUE(settled);
      const auto planned = coding.plan(*settled, always);
      ASSERT_TRUE(planned);
      EXPECT_GE(planned->parameters.cycles, 1);
      EXPECT_LE(planned->parameters.cycles, 7);
      const Quality before = coding.quality(*settled);
      const Quality after = coding.quality(*planned);
      EXPECT_LT(after.lfe_rms, 1.02 * before.lfe_rms);
      EXPECT_LT(after.max_error, 1.05 * before.max_error);
      EXPECT_LT(after.vde_rms, 1.02 * before.vde_rms);
      const auto decoded = coding.read(*planned);
      ASSERT_TRUE(decoded);
      EXPECT_EQ(*decoded, planned->positions);
    }
  }
}

TEST(CyclePlan, DELT7MoreCyclesAreTriedUntilOneIsAccepted) {
  Coding coding(test::sheet(90, 80), 8, 40);
  const auto settled = coding.settled();
  ASSERT_TRUE(settled);
  const auto planned =
      coding.plan(*settled, [](const CodedHighpass& coded) { return coded.parameters.cycles >= 3; });
  ASSERT_TRUE(planned);
  EXPECT_GE(planned->parameters.cycles, 3);
  EXPECT_LE(planned->parameters.cycles, 5);
  int tried = 0;
  const auto none = coding.plan(*settled, [&](const CodedHighpass& coded) {
    tried = std::max<int>(tried, coded.parameters.cycles);
    return false;
  });
  EXPECT_FALSE(none);
  EXPECT_LE(tried, kMostCyclesTried);  // no use in more
}

/// So that errors are where they are in the settled stream: those of another rounding would be 1.4 of the LFE
/// away.
TEST(CyclePlan, DELT7CodePlannedKeepsTheDeltas) {
  for (const double diffusion : {0.0, 1.0}) {
    Coding coding(test::sheet(90, 80), 8, 40, diffusion);
    const auto settled = coding.settled();
    const auto planned = coding.planned(6);
    ASSERT_TRUE(settled);
    ASSERT_TRUE(planned);
    EXPECT_EQ(planned->parameters.cycles, 6);
    EXPECT_EQ(planned->compact_deltas, settled->compact_deltas);
    EXPECT_LT(coding.quality(*planned).lfe_rms, 1.05 * coding.quality(*settled).lfe_rms);
    EXPECT_LT(errors_apart(*planned, *settled), 0.5 * coding.quality(*settled).lfe_rms);
    const auto decoded = coding.read(*planned);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(*decoded, planned->positions);
  }
}

TEST(CyclePlan, DELT7CodePlannedAsksForTwoLevels) {
  Coding coding(test::sheet(10, 9), 8, 4);
  const auto planned = coding.planned(4);
  ASSERT_FALSE(planned);
  EXPECT_STREQ(planned.error().rule, "DELT-7");
}

/// One cycle leaves out several times the error of quantisation; two steps of compensation make up for it.
TEST(Compensation, DELT7CyclesGiveThePositionsBackThatItIsFor) {
  Coding coding(test::sheet(90, 80), 8, 30);
  const GraphMesh& mesh = coding.mesh();
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  const Vec3 center = middle(mesh.box);
  const std::vector<std::uint32_t> anchors = anchor_rows(coding.anchors(), part);
  for (const int cycles : {1, 2, 3}) {
    SCOPED_TRACE(cycles);
    LeastSquaresSolver solver(part.graph, part.components);
    Compensation source(part, mesh.positions, center);
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

TEST(CyclePlan, DELT7SizeMakesNoDifference) {
  int cycles = 0;
  for (const double size : {1.0, 0x1p80, 0x1p-80}) {
    SCOPED_TRACE(size);
    GraphMesh mesh = test::sheet(60, 50);
    for (Vec3& position : mesh.positions) position = size * position;
    Coding coding(test::finish(std::move(mesh)), 8, 20);
    const auto settled = coding.settled();
    ASSERT_TRUE(settled);
    const auto planned = coding.plan(*settled, always);
    ASSERT_TRUE(planned);
    if (cycles == 0) cycles = planned->parameters.cycles;
    EXPECT_EQ(planned->parameters.cycles, cycles);
  }
}

TEST(CyclePlan, NothingIsPlannedWhereNothingIsSolved) {
  Coding coding(test::sheet(1, 1), 8, 1);
  const auto settled = coding.settled();
  ASSERT_TRUE(settled);
  EXPECT_FALSE(coding.plan(*settled, always));
}

TEST(Compensation, StartsFromThePositionsThemselves) {
  const GraphMesh mesh = test::fragments();
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  const Compensation source(part, mesh.positions, middle(mesh.box));
  EXPECT_TRUE(std::equal(source.positions().begin(), source.positions().end(), mesh.positions.begin(),
                         mesh.positions.end()));
  const auto deltas = delta_coordinates(part, mesh.positions);
  EXPECT_TRUE(std::equal(source.deltas().begin(), source.deltas().end(), deltas.begin(), deltas.end()));
}

TEST(PlanJudge, TellsErrorsOverTheSettledOnes) {
  const GraphMesh mesh = test::sheet(12, 9);
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  const auto moved = [&](double all, double one) {
    std::vector<Vec3> positions = mesh.positions;
    for (Vec3& position : positions) position[0] += all;
    positions[30][1] += one;
    return positions;
  };
  const std::vector<Vec3> settled = moved(0.5, 1.5);
  const PlanJudge judge(part, mesh.positions, settled, 1e-9);
  const PlanCost same = judge.cost(settled);
  EXPECT_DOUBLE_EQ(same.rms, 1);
  EXPECT_DOUBLE_EQ(same.largest, 1);
  EXPECT_DOUBLE_EQ(same.roughness, 1);
  EXPECT_TRUE(same.is_fair());
  const PlanCost twice = judge.cost(moved(1, 3));
  EXPECT_NEAR(twice.rms, 2, 1e-12);
  EXPECT_NEAR(twice.largest, 2, 1e-12);
  EXPECT_NEAR(twice.roughness, 2, 1e-12);
  EXPECT_FALSE(twice.is_close());
  const PlanCost further = judge.cost(moved(0.5, 1.6));  // one vertex only
  EXPECT_GT(further.largest, 1.02);
  EXPECT_FALSE(further.is_fair());
  const PlanCost shifted = judge.cost(moved(0.6, 1.5));  // no rougher
  EXPECT_GT(shifted.rms, 1.019);
  EXPECT_NEAR(shifted.roughness, 1, 1e-12);
  EXPECT_FALSE(shifted.is_fair());
  const PlanCost none = judge.cost(mesh.positions);
  EXPECT_EQ(none.rms, 0);
  EXPECT_TRUE(none.is_fair());
  std::vector<Vec3> lost = settled;
  lost[3][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(judge.cost(lost).is_fair());
  EXPECT_FALSE(judge.cost(lost).is_close());
}

}  // namespace
}  // namespace deltamesh
