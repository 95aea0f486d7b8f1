// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/stream.h"

#include <cstdio>

#include "report/attributes.h"

namespace deltamesh::cli {
double bits_per_vertex(std::uint64_t bytes, const StreamInfo& info) {
  return info.vertices == 0 ? 0 : 8 * static_cast<double>(bytes) / static_cast<double>(info.vertices);
}

std::string size_text(std::uint64_t bytes, const StreamInfo& info) {
  if (info.vertices == 0) return counted(bytes, "byte", "bytes");
  char rate[48];
  std::snprintf(rate, sizeof rate, ", %.2f bits per vertex", bits_per_vertex(bytes, info));
  return counted(bytes, "byte", "bytes") + rate;
}

void add_stream(nlohmann::ordered_json& object, const StreamInfo& info) {
  object["vertices"] = info.vertices;
  object["geometric_vertices"] = info.geometric_vertices;
  object["triangles"] = info.triangles;
  object["components"] = info.components;
  object["bytes"] = info.bytes;
  object["bits_per_vertex"] = bits_per_vertex(info.bytes, info);
  object["connectivity_bytes"] = info.connectivity_bytes;
  object["geometry_bytes"] = info.geometry_bytes;
  object["anchor_bytes"] = info.anchor_bytes;
  object["attribute_bytes"] = info.attribute_bytes;
  object["container_bytes"] = info.container_bytes;
  object["geometry"] = info.geometry;
  object["bits"] = info.bits == 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(info.bits);
  object["step"] = info.step;
  object["anchors"] = info.anchors;
  object["anchor_density"] = info.anchor_density;
  object["cycles"] = info.cycles;
  object["vde_rms"] = info.quality.vde_rms;
  object["lfe_rms"] = info.quality.lfe_rms;
  object["max_error"] = info.quality.max_error;
  // Of a stream in a grid the mesh's own box may not be known.
  const auto or_null = [&](double figure, double of) {
    return of > 0 || info.geometry != "grid" ? nlohmann::ordered_json(figure) : nullptr;
  };
  const PaperQuality paper = paper_form(info.quality, info.geometric_vertices, info.diagonal);
  object["vde_paper"] = or_null(paper.vde, info.diagonal);
  object["lfe_paper"] = or_null(paper.lfe, info.diagonal);
  object["diagonal"] = or_null(info.diagonal, info.diagonal);
  object["extent"] = or_null(info.extent, info.extent);
  object["stray_vertices"] = info.stray_vertices;
  object["attributes"] = attributes_object(info);
}

void add_extent(Summary& summary, const StreamInfo& info) {
  if (info.stray_vertices == 0) return;
  summary.add("stray", counted(info.stray_vertices, "vertex", "vertices") +
                           " far from all others; percents are of " + brief(info.extent) +
                           ", the diagonal of the rest");
}

void add_sizes(Summary& summary, const StreamInfo& info) {
  summary.add("size", size_text(info.bytes, info));
  const bool in_grid = info.geometry == "grid";
  if (!in_grid) summary.add("  connectivity", size_text(info.connectivity_bytes, info));
  summary.add("  geometry", size_text(info.geometry_bytes, info) + (in_grid ? ", connectivity too" : ""));
  if (info.geometry == "highpass") summary.add("  anchors", size_text(info.anchor_bytes, info));
  summary.add("  container", size_text(info.container_bytes, info));
  if (info.attribute_bytes > 0) summary.add("  attributes", size_text(info.attribute_bytes, info));
}

void add_settings(Summary& summary, const StreamInfo& info) {
  summary.add("geometry", info.geometry + (info.bits > 0 ? ", " + std::to_string(info.bits) + " bits" : "") +
                              ", step " + brief(info.step));
  if (info.geometry != "highpass") return;
  summary.add("anchors", grouped(info.anchors) + ", every vertex within " +
                             counted(info.anchor_density, "edge", "edges") + " of one");
  summary.add("solver", counted(static_cast<std::uint64_t>(info.cycles), "cycle", "cycles"));
}

void add_errors(Summary& summary, const Quality& quality, double diagonal) {
  summary.add("VDE (rms)", of_diagonal(quality.vde_rms, diagonal));
  summary.add("LFE (rms)", of_diagonal(quality.lfe_rms, diagonal));
  summary.add("max error", of_diagonal(quality.max_error, diagonal));
}

}  // namespace deltamesh::cli
