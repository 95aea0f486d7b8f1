// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cstdlib>

#include "entropy/coder/pricer.h"
#include "field/field_coder.h"
#include "highpass/compact.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh {
namespace {

/// Sums of uniform numbers: small ones often, a few large.
std::vector<std::int32_t> some_symbols(std::size_t count) {
  test::RandomBits random(7);
  std::vector<std::int32_t> symbols(count);
  for (std::int32_t& q : symbols) {
    q = static_cast<std::int32_t>(random() % 5) - static_cast<std::int32_t>(random() % 5);
    if (random() % 50 == 0) q *= 30;
  }
  return symbols;
}

TEST(CompactPricer, PricesAddUpToTheStream) {
  const auto mesh = test::sheet(50, 50);
  const std::size_t n = mesh.graph.vertex_count();
  const std::vector<std::int32_t> symbols = some_symbols(3 * n);
  CompactPricer pricer;
  FieldCoder<CompactPricer> field(pricer, mesh.graph);
  double bits = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    field.choose_vertex(v, [&](unsigned axis, const auto& price) {
      const std::int32_t q = symbols[axis * n + v];
      const double once = price(q);
      EXPECT_EQ(price(q), once);  // a trial teaches nothing
      EXPECT_GT(once, 0);
      bits += once;
      return q;
    });
  }
  const double coded = 8.0 * static_cast<double>(write_compact_deltas(symbols, mesh.graph).size());
  EXPECT_NEAR(bits, coded, 0.0025 * coded);
}

TEST(CompactPricer, LargeNumbersHavePrices) {
  const auto mesh = test::sheet(5, 5);
  CompactPricer pricer;
  FieldCoder<CompactPricer> field(pricer, mesh.graph);
  field.choose_vertex(0, [](unsigned, const auto& price) {
    EXPECT_GT(price(kLargestFieldValue), price(1000));
    EXPECT_GT(price(-kLargestFieldValue), price(-1000));
    EXPECT_LT(price(kLargestFieldValue), 100);
    return 0;
  });
}

}  // namespace
}  // namespace deltamesh
