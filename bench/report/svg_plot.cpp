// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/svg_plot.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "report/axis.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

constexpr int kWidth = 1010;
constexpr int kHeight = 580;
constexpr int kLeft = 90;
constexpr int kRight = kWidth - 180;
constexpr int kTop = 50;
constexpr int kBottom = kHeight - 80;
constexpr int kLegendWidth = 150;
constexpr int kLegendStep = 22;

/// Colours that stay apart for colour-blind readers (Okabe and Ito), each with its own marker.
struct SeriesStyle {
  const char* color;
  const char* marker;  ///< path around (0, 0)
};
constexpr std::array<SeriesStyle, 6> kStyles = {{
    {"#0072b2", "M-4,0 a4,4 0 1,0 8,0 a4,4 0 1,0 -8,0 z"},
    {"#d55e00", "M-4,-4 h8 v8 h-8 z"},
    {"#e69f00", "M0,-5 L5,0 L0,5 L-5,0 z"},
    {"#666666", "M0,-5 L5,4 L-5,4 z"},
    {"#009e73", "M0,5 L5,-4 L-5,-4 z"},
    {"#cc79a7", "M-5,-2 h3 v-3 h4 v3 h3 v4 h-3 v3 h-4 v-3 h-3 z"},
}};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string pixel(double value) { return fixed(value, 1); }

std::string line_element(double x1, double y1, double x2, double y2, const char* color) {
  return join({"<line x1=\"", pixel(x1), "\" y1=\"", pixel(y1), "\" x2=\"", pixel(x2), "\" y2=\"", pixel(y2),
               "\" stroke=\"", color, "\"/>\n"});
}

std::string text_element(double x, double y, std::string_view attributes, const std::string& text) {
  return join(
      {"<text x=\"", pixel(x), "\" y=\"", pixel(y), "\" ", attributes, ">", escaped(text), "</text>\n"});
}

std::string marker_element(double x, double y, const SeriesStyle& style, const std::string& note) {
  return join({"<path transform=\"translate(", pixel(x), ",", pixel(y), ")\" d=\"", style.marker,
               "\" fill=\"", style.color, "\" stroke=\"white\" stroke-width=\"0.8\"><title>", escaped(note),
               "</title></path>\n"});
}

std::string rect_element(double x, double y, double width, double height, const char* fill,
                         const char* stroke) {
  return join({"<rect x=\"", pixel(x), "\" y=\"", pixel(y), "\" width=\"", pixel(width), "\" height=\"",
               pixel(height), "\" fill=\"", fill, "\" stroke=\"", stroke, "\"/>\n"});
}

/// `points`: pixels as SVG writes them, "x,y x,y".
std::string polyline_element(const std::string& points, const char* color) {
  return join(
      {"<polyline fill=\"none\" stroke-width=\"2\" stroke=\"", color, "\" points=\"", points, "\"/>\n"});
}

/// A tenth more than the data needs, so that no marker sits on the frame.
constexpr double kMargin = 1.1;

std::vector<double> coordinates(const Plot& plot, double PlotPoint::*coordinate) {
  std::vector<double> values;
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) values.push_back(point.*coordinate);
    for (const PlotPoint& point : series.line) values.push_back(point.*coordinate);
  }
  return values;
}

LinearAxis make_x_axis(const Plot& plot) {
  const auto values = coordinates(plot, &PlotPoint::x);
  return {*std::max_element(values.begin(), values.end()) * kMargin, kLeft, kRight};
}

LogAxis make_y_axis(const Plot& plot) {
  const auto values = coordinates(plot, &PlotPoint::y);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low / kMargin, *high * kMargin, kBottom, kTop};
}

class Canvas {
 public:
  explicit Canvas(const Plot& plot) : plot_(plot), x_(make_x_axis(plot)), y_(make_y_axis(plot)) {}

  std::string render() const {
    const std::string width = std::to_string(kWidth);
    const std::string height = std::to_string(kHeight);
    std::string svg =
        join({"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", width, "\" height=\"", height,
              "\" viewBox=\"0 0 ", width, " ", height, "\" font-family=\"sans-serif\" font-size=\"13\">\n"});
    svg += rect_element(0, 0, kWidth, kHeight, "white", "none");
    svg += text_element(kLeft, kTop - 20, "font-size=\"16\" font-weight=\"bold\"", plot_.title);
    svg += axes();
    for (std::size_t s = 0; s < plot_.series.size(); ++s) svg += series(plot_.series[s], kStyles[s]);
    svg += legend();
    svg += "</svg>\n";
    return svg;
  }

 private:
  std::string axes() const {
    constexpr const char* kGrid = "#d8d8d8";
    constexpr const char* kFaintGrid = "#f0f0f0";
    std::string svg;
    for (const Tick& tick : x_.ticks()) {
      const double x = x_.place(tick.value);
      svg += line_element(x, kTop, x, kBottom, tick.label.empty() ? kFaintGrid : kGrid);
      svg += text_element(x, kBottom + 20, "text-anchor=\"middle\"", tick.label);
    }
    for (const Tick& tick : y_.ticks()) {
      const double y = y_.place(tick.value);
      svg += line_element(kLeft, y, kRight, y, tick.label.empty() ? kFaintGrid : kGrid);
      svg += text_element(kLeft - 8, y + 4.5, "text-anchor=\"end\"", tick.label);
    }
    svg += rect_element(kLeft, kTop, kRight - kLeft, kBottom - kTop, "none", "black");
    svg += text_element((kLeft + kRight) / 2.0, kBottom + 43, "text-anchor=\"middle\"", plot_.x_label);
    svg += text_element(kLeft, kHeight - 12, "font-size=\"12\" fill=\"#555555\"", plot_.footnote);
    const double middle = (kTop + kBottom) / 2.0;
    const std::string turned =
        join({"text-anchor=\"middle\" transform=\"rotate(-90 22 ", pixel(middle), ")\""});
    return svg + text_element(22, middle, turned, plot_.y_label);
  }

  std::string series(const PlotSeries& series, const SeriesStyle& style) const {
    std::string line;
    for (const PlotPoint& point : series.line)
      line += join({pixel(x_.place(point.x)), ",", pixel(y_.place(point.y)), " "});
    std::string svg = polyline_element(line, style.color);
    for (std::size_t i = 0; i < series.points.size(); ++i)
      svg += marker_element(x_.place(series.points[i].x), y_.place(series.points[i].y), style,
                            join({series.name, " ", series.notes[i]}));
    return svg;
  }

  /// Beside the frame, where it hides nothing.
  std::string legend() const {
    const double left = kRight + 15;
    const double height = kLegendStep * static_cast<double>(plot_.series.size()) + 8;
    std::string svg = rect_element(left, kTop, kLegendWidth, height, "white", "#888888");
    for (std::size_t s = 0; s < plot_.series.size(); ++s) {
      const double y = kTop + 15 + kLegendStep * static_cast<double>(s);
      svg += polyline_element(join({pixel(left + 8), ",", pixel(y), " ", pixel(left + 36), ",", pixel(y)}),
                              kStyles[s].color);
      svg += marker_element(left + 22, y, kStyles[s], plot_.series[s].name);
      svg += text_element(left + 44, y + 4.5, "", plot_.series[s].name);
    }
    return svg;
  }

  const Plot& plot_;
  LinearAxis x_;
  LogAxis y_;
};

}  // namespace

std::string render_svg(const Plot& plot) { return Canvas(plot).render(); }

}  // namespace deltamesh::bench
