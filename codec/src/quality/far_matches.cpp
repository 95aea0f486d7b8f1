// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/far_matches.h"

#include <algorithm>

namespace deltamesh {
namespace {

/// Largest distance of a corner of face `f` of `b` from that of its match.
double match_distance(const FaceGraph& a, const FaceGraph& b, std::uint32_t f, const FaceMatch& match) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max(largest, length(b.at(f, k) - a.at(match.face, (k + match.turn) % 3)));
  return largest;
}

/// 0 of none.
double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void drop_far_matches(const FaceGraph& a, const FaceGraph& b, std::vector<FaceMatch>& matches) {
  constexpr double kCredible = 0.25;  // of an edge: less cannot be chance where neighbours meet neighbours
  std::vector<double> distances;
  std::vector<double> edges;
  for (std::uint32_t f = 0; f < b.real_faces; ++f) {
    if (matches[f].face == kNoFace) continue;
    distances.push_back(match_distance(a, b, f, matches[f]));
    edges.push_back(a.longest_edge(matches[f].face));
  }
  const double typical = median(distances);
  const bool credible = typical <= kCredible * median(edges);
  for (std::uint32_t f = 0; f < matches.size(); ++f) {
    FaceMatch& match = matches[f];
    if (match.face == kNoFace) continue;
    const double most = std::max(4 * typical, kCredible * a.longest_edge(match.face));
    if (!credible || match_distance(a, b, f, match) > most) match = {};
  }
}

}  // namespace deltamesh
