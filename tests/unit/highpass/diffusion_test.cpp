// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/diffusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "highpass/compact.h"
#include "laplacian/operator/delta.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

/// Sum of degree times error of every vertex: what the left null vector of L sees.
Vec3 charge(const Adjacency& graph, std::span<const Vec3> deltas, const std::vector<std::int32_t>& symbols,
            const DeltaQuantizer& quantizer) {
  Vec3 sum{};
  const std::size_t n = deltas.size();
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum[axis] += graph.degree(i) * (deltas[i][axis] - quantizer.value(symbols[axis * n + i]));
  }
  return sum;
}

/// Root mean square over the vertices.
double rms_error(std::span<const Vec3> deltas, const std::vector<std::int32_t>& symbols,
                 const DeltaQuantizer& quantizer) {
  double sum = 0;
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double error = deltas[i][axis] - quantizer.value(symbols[axis * deltas.size() + i]);
      sum += error * error;
    }
  }
  return std::sqrt(sum / static_cast<double>(deltas.size()));
}

TEST(Diffusion, OffQuantisesEveryDeltaAlone) {
  const auto mesh = test::sheet(12, 9);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  const DeltaQuantizer quantizer{.step = 0.05};
  const auto symbols = quantize_deltas(mesh.graph, deltas, quantizer, 0);
  ASSERT_TRUE(symbols);
  for (std::size_t i = 0; i < deltas.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR((*symbols)[axis * deltas.size() + i] * 0.05, deltas[i][axis], 0.025 + 1e-12);
}

TEST(Diffusion, ConservesChargeUpToWhatTheLastVertexKeeps) {
  const auto mesh = test::sheet(40, 30);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  const DeltaQuantizer quantizer{.step = 0.2};
  const auto plain = quantize_deltas(mesh.graph, deltas, quantizer, 0);
  const auto diffused = quantize_deltas(mesh.graph, deltas, quantizer, 1);
  ASSERT_TRUE(plain && diffused);
  // Only the last vertex has no later neighbour: what is lost is its degree times half a step.
  const double most = mesh.graph.degree(static_cast<std::uint32_t>(deltas.size() - 1)) * 0.1 + 1e-9;
  for (const double lost : charge(mesh.graph, deltas, *diffused, quantizer)) EXPECT_LE(std::abs(lost), most);
  EXPECT_GT(length(charge(mesh.graph, deltas, *plain, quantizer)), 10 * most);
}

TEST(Diffusion, ShiftedReconstructionIsWhatIsDiffused) {
  const auto mesh = test::sheet(30, 30);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  const DeltaQuantizer quantizer{.step = 0.3, .shift = {.one = 40, .more = -20}};
  const auto symbols = quantize_deltas(mesh.graph, deltas, quantizer, 1);
  ASSERT_TRUE(symbols);
  const double most = mesh.graph.degree(static_cast<std::uint32_t>(deltas.size() - 1)) * 0.3 * 0.7;
  for (const double lost : charge(mesh.graph, deltas, *symbols, quantizer)) EXPECT_LE(std::abs(lost), most);
}

TEST(Diffusion, TooSmallAStepIsAnError) {
  const auto mesh = test::sheet(5, 5);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  const auto symbols = quantize_deltas(mesh.graph, deltas, {.step = 1e-12}, 1);
  ASSERT_FALSE(symbols);
  EXPECT_EQ(symbols.error().code, ErrorCode::kInvalidArgument);
}

TEST(DeltaQuantizer, DELT2RoundsAndReconstructsSymmetrically) {
  const DeltaQuantizer nearest{.step = 2};
  EXPECT_EQ(nearest.symbol(0.99), 0);
  EXPECT_EQ(nearest.symbol(1.01), 1);
  EXPECT_EQ(nearest.symbol(-2.9), -1);
  EXPECT_EQ(nearest.symbol(-3.1), -2);
  const DeltaQuantizer shifted{.step = 2, .shift = {.one = 64, .more = -128}};
  EXPECT_EQ(shifted.value(0), 0);
  EXPECT_EQ(shifted.value(1), 1.5);
  EXPECT_EQ(shifted.value(-1), -1.5);
  EXPECT_EQ(shifted.value(3), 7);
  EXPECT_EQ(shifted.value(std::numeric_limits<std::int32_t>::min()), -2 * (2147483648.0 + 0.5));
}

TEST(DeltaQuantizer, CentroidShiftIsTheMeanOfTheBin) {
  const std::vector<Vec3> deltas{{0.75, -0.75, 0.1}, {2.25, -2.25, 0}};
  const ReconstructionShift shift = BinErrors(1, deltas).centroids();
  EXPECT_EQ(shift.one, 64);
  EXPECT_EQ(shift.more, -64);
  EXPECT_EQ(BinErrors(100, deltas).centroids(), ReconstructionShift{});
}

TEST(DeltaQuantizer, BinErrorsAreThoseOfTheSymbols) {
  const auto mesh = test::sheet(30, 30);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  const auto symbols = quantize_deltas(mesh.graph, deltas, {.step = 0.1}, 0);
  ASSERT_TRUE(symbols);
  const BinErrors alone(0.1, deltas);
  const BinErrors given(0.1, deltas, *symbols);
  const ReconstructionShift shift = alone.centroids();
  EXPECT_EQ(given.centroids(), shift);
  EXPECT_NEAR(given.rms(shift), rms_error(deltas, *symbols, {.step = 0.1, .shift = shift}), 1e-12);
  EXPECT_NEAR(alone.rms(shift), given.rms(shift), 1e-12);
  EXPECT_LT(alone.rms(shift), alone.rms({}));
}

/// Of six steps together: of one, either may be the luckier.
TEST(FrugalSymbols, AreCheaperAtTheSameError) {
  const auto mesh = test::sheet(60, 60);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  std::size_t frugal_bytes = 0;
  std::size_t plain_bytes = 0;
  for (double step = 0.01; step < 0.5; step *= 2) {
    const auto frugal = quantize_deltas(mesh.graph, deltas, {.step = step}, 0, 0.12);
    ASSERT_TRUE(frugal);
    for (std::size_t i = 0; i < deltas.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t q = (*frugal)[axis * deltas.size() + i];
        EXPECT_LE(std::abs(deltas[i][axis] / step - q), 1.5);
        EXPECT_LE(std::abs(q), std::abs(DeltaQuantizer{.step = step}.symbol(deltas[i][axis])));
      }
    }
    // The step at which plain rounding has the same error.
    const BinErrors errors(step, deltas, *frugal);
    const double error = errors.rms(errors.centroids());
    double plain_step = step;
    for (int i = 0; i < 20; ++i) {
      const BinErrors plain(plain_step, deltas);
      plain_step *= error / plain.rms(plain.centroids());
    }
    const auto plain = quantize_deltas(mesh.graph, deltas, {.step = plain_step}, 0);
    ASSERT_TRUE(plain);
    frugal_bytes += write_compact_deltas(*frugal, mesh.graph).size();
    plain_bytes += write_compact_deltas(*plain, mesh.graph).size();
  }
  EXPECT_LT(frugal_bytes, plain_bytes);
}

}  // namespace
}  // namespace deltamesh
