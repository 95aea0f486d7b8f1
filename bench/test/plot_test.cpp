// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "report/axis.h"
#include "report/svg_plot.h"

namespace deltamesh::bench {
namespace {

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(LogAxis, WidensToTicksAndPlacesThem) {
  const LogAxis axis(0.15, 32, 0, 100);
  EXPECT_NEAR(axis.place(0.1), 0, 1e-9);
  EXPECT_NEAR(axis.place(40), 100, 1e-9);
  const auto ticks = axis.ticks();
  EXPECT_NEAR(ticks.front().value, 0.1, 1e-12);
  EXPECT_NEAR(ticks.back().value, 40, 1e-9);
  EXPECT_EQ(ticks.front().label, "0.1");
}

TEST(LogAxis, ExactTickValuesStay) {
  for (const double low : {0.001, 0.003, 1.0, 7.0, 1000.0}) {
    const LogAxis axis(low, low * 10, 0, 1);
    EXPECT_NEAR(axis.place(low), 0, 1e-9) << low;
    EXPECT_NEAR(axis.place(low * 10), 1, 1e-9) << low;
  }
}

TEST(LogAxis, ASingleValueHasARange) {
  const LogAxis axis(5, 5, 10, 20);
  EXPECT_GE(axis.place(5), 10);
  EXPECT_LE(axis.place(5), 20);
  EXPECT_GE(axis.ticks().size(), 2U);
}

TEST(LogAxis, LabelsAreNeitherManyNorFew) {
  for (const double high : {1.5, 3.0, 8.0, 20.0, 90.0, 1e3, 1e5}) {
    const auto ticks = LogAxis(1, high, 0, 1).ticks();
    const auto labels =
        std::count_if(ticks.begin(), ticks.end(), [](const Tick& t) { return !t.label.empty(); });
    EXPECT_GE(labels, 2) << high;
    EXPECT_LE(labels, 12) << high;
  }
}

TEST(LinearAxis, StartsAtZeroAndEndsOnATick) {
  for (const double high : {0.7, 1.0, 9.9, 10.0, 19.8, 64.0, 123.0}) {
    const LinearAxis axis(high, 0, 100);
    const auto ticks = axis.ticks();
    EXPECT_GE(ticks.size(), 5U) << high;
    EXPECT_LE(ticks.size(), 11U) << high;
    EXPECT_NEAR(axis.place(0), 0, 1e-9);
    EXPECT_NEAR(axis.place(ticks.back().value), 100, 1e-9);
    EXPECT_LE(axis.place(high), 100 + 1e-6) << high;
  }
}

TEST(SvgPlot, DrawsEveryPointAndEscapesText) {
  Plot plot{.title = "a < b & c", .x_label = "x", .y_label = "y", .footnote = "f", .series = {}};
  plot.series.push_back(
      {.name = "one", .points = {{1, 1}, {2, 3}}, .line = {{1, 1}, {2, 3}}, .notes = {"a", "b"}});
  plot.series.push_back({.name = "two", .points = {{5, 5}}, .line = {}, .notes = {"c"}});
  const std::string svg = render_svg(plot);
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(occurrences(svg, "<path "), 3U + 2U) << "points and legend";
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace deltamesh::bench
