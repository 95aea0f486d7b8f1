// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A scatter plot with lines, linear from 0 to the right and logarithmic upwards, as an SVG file.
#pragma once

#include <string>
#include <vector>

namespace deltamesh::bench {

struct PlotPoint {
  double x = 0;  ///< finite, above 0
  double y = 0;  ///< finite, above 0
};

struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;  ///< markers
  std::vector<PlotPoint> line;
  std::vector<std::string> notes;  ///< one per point, shown where the pointer rests
};

struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::string footnote;
  std::vector<PlotSeries>
      series;  ///< at most 6: there are as many styles; together at least one point, of a line or by itself
};

/// Text of the file.
std::string render_svg(const Plot& plot);

}  // namespace deltamesh::bench
