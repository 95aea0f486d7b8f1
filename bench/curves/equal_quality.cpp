// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/equal_quality.h"

#include "curves/hull.h"
#include "curves/ladder.h"

namespace deltamesh::bench {

std::vector<EqualQualityRow> equal_quality(const Run& run, const ErrorKind& kind, std::string_view peer) {
  std::vector<EqualQualityRow> rows;
  for (const std::string& mesh : mesh_names(run)) {
    std::vector<CurvePoint> points;
    for (const Measurement& m : run.measurements)
      if (m.mesh == mesh && m.peer == peer)
        points.push_back({.error = kind.percent(m), .bytes = static_cast<double>(m.bytes)});
    const auto hull = lower_hull(points);
    EqualQualityRow row{.mesh = mesh, .ratios = {}};
    for (const Measurement& m : run.measurements) {
      if (m.mesh != mesh || m.peer != kReferenceName) continue;
      for (std::size_t i = 0; i < kReferenceSettings.size(); ++i) {
        if (m.setting != kReferenceSettings[i]) continue;
        const double error = kind.percent(m);
        if (const auto bytes = bytes_at(hull, error))
          row.ratios[i] = SizeRatio{.value = *bytes / static_cast<double>(m.bytes),
                                    .is_upper_bound = error > hull.back().error};
      }
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace deltamesh::bench
