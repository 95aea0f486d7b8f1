// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/diffusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "laplacian/delta.h"
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
  const DeltaQuantizer quantizer{.step = 0.3, .rounding = 0.4, .shift = {.one = 40, .more = -20}};
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
  const DeltaQuantizer lazy{.step = 2, .rounding = 0.25};
  EXPECT_EQ(lazy.symbol(1.4), 0);
  EXPECT_EQ(lazy.symbol(-1.6), -1);
  const DeltaQuantizer shifted{.step = 2, .shift = {.one = 64, .more = -128}};
  EXPECT_EQ(shifted.value(0), 0);
  EXPECT_EQ(shifted.value(1), 1.5);
  EXPECT_EQ(shifted.value(-1), -1.5);
  EXPECT_EQ(shifted.value(3), 7);
  EXPECT_EQ(shifted.value(std::numeric_limits<std::int32_t>::min()), -2 * (2147483648.0 + 0.5));
}

TEST(DeltaQuantizer, CentroidShiftIsTheMeanOfTheBin) {
  const std::vector<Vec3> deltas{{0.75, -0.75, 0.1}, {2.25, -2.25, 0}};
  const ReconstructionShift shift = BinErrors({.step = 1}, deltas).centroids();
  EXPECT_EQ(shift.one, 64);
  EXPECT_EQ(shift.more, -64);
  EXPECT_EQ(BinErrors({.step = 100}, deltas).centroids(), ReconstructionShift{});
}

TEST(DeltaQuantizer, BinErrorsAreThoseOfTheSymbols) {
  const auto mesh = test::sheet(30, 30);
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  DeltaQuantizer quantizer{.step = 0.1, .rounding = 0.4};
  const BinErrors errors(quantizer, deltas);
  quantizer.shift = errors.centroids();
  const double expected = quantization_error(mesh.graph, deltas, quantizer, 0);
  const double count = static_cast<double>(deltas.size());
  EXPECT_NEAR(std::sqrt(errors.squares(quantizer.shift) / count), expected, 1e-9);
  EXPECT_LT(errors.squares(quantizer.shift), errors.squares({}));
}

}  // namespace
}  // namespace deltamesh
