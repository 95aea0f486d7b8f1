// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/request_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "base/try.h"

namespace deltamesh::bench {
namespace {

std::string percent_name(const char* what, double percent, const char* of) {
  char name[64];
  std::snprintf(name, sizeof name, "%s %g %% %s", what, percent, of);
  return name;
}

QualityBound of_diagonal(double percent) { return {.value = percent, .unit = QualityUnit::kDiagonal}; }

double in_model_units(const QualityBound& bound, double diagonal) {
  return bound.unit == QualityUnit::kDiagonal ? bound.value / 100 * diagonal : bound.value;
}

}  // namespace

double edge_length_rms(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
    const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = double{mesh.positions[3 * std::size_t{mesh.triangles[corner]} + axis]} -
                       double{mesh.positions[3 * std::size_t{mesh.triangles[next]} + axis]};
      sum += d * d;
    }
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1)));
}

double diagonal_of(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3 && !mesh.positions.empty(); ++axis) {
    float low = mesh.positions[axis];
    float high = low;
    for (std::size_t i = axis; i < mesh.positions.size(); i += 3) {
      low = std::min(low, mesh.positions[i]);
      high = std::max(high, mesh.positions[i]);
    }
    sum += (double{high} - low) * (double{high} - low);
  }
  return std::sqrt(sum);
}

std::vector<NamedRequest> usual_requests(const Mesh& mesh, double diagonal) {
  std::vector<NamedRequest> requests;
  const double edge = edge_length_rms(mesh);
  for (const double percent : {0.2, 0.05, 0.01}) {
    requests.push_back({percent_name("VDE", percent, "of diagonal"), {.vde = of_diagonal(percent)}});
    requests.push_back(
        {percent_name("VDE", percent, "of edges"), {.vde = QualityBound{.value = percent / 100 * edge}}});
  }
  for (const double percent : {0.5, 0.1, 0.02}) {
    requests.push_back({percent_name("LFE", percent, "of diagonal"), {.lfe = of_diagonal(percent)}});
    requests.push_back({percent_name("VDE 0.02 %, LFE", percent, "of diagonal"),
                        {.vde = of_diagonal(0.02), .lfe = of_diagonal(percent)}});
  }
  for (const double percent : {0.5, 0.05})
    requests.push_back({percent_name("largest error", percent, "of diagonal"),
                        {.max_error = QualityBound{percent / 100 * diagonal}}});
  return requests;
}

Result<RequestFigures> measure_request(const Mesh& mesh, double diagonal, const EncodeOptions& options) {
  const std::clock_t start = std::clock();
  DELTAMESH_TRY(const Encoded encoded, encode(mesh, options));
  RequestFigures figures;
  figures.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  figures.bytes = encoded.bytes.size();
  const Quality& quality = encoded.report.stream.quality;
  const QualityRequest& asked = options.quality;
  if (asked.vde) figures.vde_load = quality.vde_rms / in_model_units(*asked.vde, diagonal);
  if (asked.lfe) figures.lfe_load = quality.lfe_rms / in_model_units(*asked.lfe, diagonal);
  if (asked.max_error) figures.max_load = quality.max_error / asked.max_error->value;
  return figures;
}

}  // namespace deltamesh::bench
