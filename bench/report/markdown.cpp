// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/markdown.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "deltamesh/version.h"
#include "peers/ladder.h"
#include "report/equal_quality.h"
#include "report/geometric_mean.h"
#include "report/text.h"
#include "run/machine.h"

namespace deltamesh::bench {
namespace {

constexpr const char* kNone = "–";
constexpr const char* kFigureColumns =
    "bits per vertex | VDE % | LFE % | max error % | encode ns per vertex | decode ns per vertex |\n";

std::string heading() {
  return join(
      {"| commit | compiler | flags | CPU | deltamesh | Draco | zstd |\n|---|---|---|---|---|---|---|\n| ",
       kBuildInfo.commit, " | ", kBuildInfo.compiler, " | `", kBuildInfo.flags, "` | ", processor_name(),
       " | ", kLibraryVersion, " | ", draco_version(), " | ", zstd_version(), " |\n\n"});
}

std::string explanation(const Run& run) {
  return join(
      {"Meshes: ", run.meshes,
       ". Every peer gets the same mesh: positions and triangles only, equal positions welded, degenerate "
       "faces and unused vertices dropped. One thread. Times are processor times, medians of up to ",
       std::to_string(run.timing.repeats), " runs (fewer where they take more than ",
       significant(run.timing.seconds, 3),
       " s together). Our encoder also decodes and measures its own result. VDE and LFE are root mean "
       "squares, all errors in percent of the bounding box's diagonal. Settings of deltamesh: bits of the "
       "delta quantiser and anchors as a share of the vertices, or the error that was asked for, in "
       "percent.\n\n"});
}

std::string ratio_cell(const std::optional<SizeRatio>& ratio) {
  if (!ratio) return kNone;
  return join({ratio->is_upper_bound ? "≤ " : "", fixed(ratio->value, 2)});
}

using Ratios = decltype(EqualQualityRow::ratios);
using RatioMeans = std::array<GeometricMean, kReferenceSettings.size()>;

std::string table_head(std::string_view first) {
  std::string text = join({"| ", first, " |"});
  for (const char* setting : kReferenceSettings) text += join({" ", setting, " |"});
  text += "\n|---|";
  for (std::size_t i = 0; i < kReferenceSettings.size(); ++i) text += "---:|";
  return text + '\n';
}

void add(RatioMeans& means, const Ratios& ratios) {
  for (std::size_t i = 0; i < means.size(); ++i)
    if (ratios[i]) means[i].add(ratios[i]->value);
}

std::string mean_row(std::string_view title, const RatioMeans& means) {
  std::string text = join({"| **", title, "** |"});
  for (const GeometricMean& mean : means) {
    const auto value = mean.value();
    text += join({" **", value ? fixed(*value, 3) : kNone, "** |"});
  }
  return text + '\n';
}

/// "robot" of "robot/kitchen".
std::string group_of(const std::string& mesh) { return mesh.substr(0, mesh.find('/')); }

std::string equal_quality_table(const Run& run, const ErrorKind& kind) {
  std::string text = join({"### Equal ", kind.name, "\n\n"}) + table_head("mesh");
  RatioMeans all;
  std::vector<std::pair<std::string, RatioMeans>> groups;
  for (const EqualQualityRow& row : equal_quality(run, kind, kOurName)) {
    text += join({"| ", row.mesh, " |"});
    for (const auto& ratio : row.ratios) text += join({" ", ratio_cell(ratio), " |"});
    text += '\n';
    add(all, row.ratios);
    if (groups.empty() || groups.back().first != group_of(row.mesh))
      groups.push_back({group_of(row.mesh), RatioMeans{}});
    add(groups.back().second, row.ratios);
  }
  if (groups.size() > 1)
    for (const auto& [name, means] : groups) text += mean_row("geometric mean, " + name, means);
  return text + mean_row("geometric mean", all) + '\n';
}

/// Every peer's geometric means.
std::string peers_table(const Run& run, const ErrorKind& kind) {
  std::string text =
      join({"### Every peer at equal ", kind.name, ", geometric means\n\n"}) + table_head("peer");
  for (const std::string& peer : peer_names(run)) {
    RatioMeans means;
    for (const EqualQualityRow& row : equal_quality(run, kind, peer)) add(means, row.ratios);
    text += mean_row(peer, means);
  }
  return text + '\n';
}

std::string equal_quality_section(const Run& run) {
  std::string text =
      join({"## Bytes of deltamesh relative to ", kReferenceName,
            " at equal error\n\nInterpolated over the logarithm of the error, on the lower hull of our "
            "settings. \"≤\": our "
            "coarsest setting already has a smaller error; \"",
            kNone, "\": no setting of the ladder has so small an error; means leave those out.\n\n"});
  for (const ErrorKind& kind : kErrorKinds) text += equal_quality_table(run, kind);
  for (const ErrorKind& kind : kErrorKinds) text += peers_table(run, kind);
  return text;
}

/// Where our bytes go, in percent.
std::string shares_section(const Run& run) {
  std::string text =
      "## Where the bytes go\n\n| mesh | setting | bytes | connectivity % | geometry % | anchors % | "
      "attributes % | "
      "container % |\n|---|---|---:|---:|---:|---:|---:|---:|\n";
  for (const Measurement& m : run.measurements) {
    if (!m.shares) continue;
    text += join({"| ", m.mesh, " | ", m.setting, " | ", std::to_string(m.bytes), " |"});
    for (const std::uint64_t part : {m.shares->connectivity, m.shares->geometry, m.shares->anchors,
                                     m.shares->attributes, m.shares->container})
      text += join({" ", fixed(100 * static_cast<double>(part) / static_cast<double>(m.bytes), 1), " |"});
    text += '\n';
  }
  return text + '\n';
}

/// The figures of one or, as geometric means, of several measurements.
class FigureRow {
 public:
  void add(const Measurement& m) {
    const double per_vertex = 1e9 / static_cast<double>(m.vertices);
    const double figures[] = {m.bits_per_vertex(),           m.percent(m.quality.vde_rms),
                              m.percent(m.quality.lfe_rms),  m.percent(m.quality.max_error),
                              m.encode_seconds * per_vertex, m.decode_seconds * per_vertex};
    for (std::size_t i = 0; i < means_.size(); ++i) means_[i].add(figures[i]);
  }

  std::string cells() const {
    std::string text;
    for (std::size_t i = 0; i < means_.size(); ++i) {
      const auto value = means_[i].value();
      const bool is_time = i >= 4;
      text += join({" ", !value ? kNone : is_time ? fixed(*value, 0) : significant(*value, 4), " |"});
    }
    return text;
  }

 private:
  std::array<GeometricMean, 6> means_;
};

std::string means_section(const Run& run) {
  using Place = std::pair<std::string, std::string>;
  std::vector<std::pair<Place, FigureRow>> rows;
  for (const Measurement& m : run.measurements) {
    const Place place{m.peer, m.setting};
    auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.first == place; });
    if (row == rows.end()) row = rows.insert(rows.end(), {place, FigureRow{}});
    row->second.add(m);
  }
  std::string text = join({"## Geometric means over the meshes\n\n| peer | setting | ", kFigureColumns,
                           "|---|---|---:|---:|---:|---:|---:|---:|\n"});
  for (const auto& [place, row] : rows)
    text += join({"| ", place.first, " | ", place.second, " |", row.cells(), "\n"});
  text += '\n';
  return text;
}

std::string mesh_section(const Run& run, const std::string& mesh) {
  std::string rows;
  std::string counts;
  for (const Measurement& m : run.measurements) {
    if (m.mesh != mesh) continue;
    counts = join({std::to_string(m.vertices), " vertices, ", std::to_string(m.triangles), " triangles"});
    FigureRow row;
    row.add(m);
    rows += join({"| ", m.peer, " | ", m.setting, " | ", std::to_string(m.bytes), " |", row.cells(), "\n"});
  }
  return join({"## ", mesh, "\n\n", counts, "\n\n| peer | setting | bytes | ", kFigureColumns,
               "|---|---|---:|---:|---:|---:|---:|---:|---:|\n", rows, "\n"});
}

std::string failure_section(const Run& run) {
  if (run.failures.empty()) return {};
  std::string text = "## Failed\n\n| mesh | peer | why |\n|---|---|---|\n";
  for (const Failure& failure : run.failures)
    text += join({"| ", failure.mesh, " | ", failure.peer, " | ", failure.reason, " |\n"});
  text += '\n';
  return text;
}

}  // namespace

std::string render_markdown(const Run& run) {
  std::string text = "# deltamesh beside its peers\n\n" + heading() + explanation(run) +
                     failure_section(run) + equal_quality_section(run) + shares_section(run) +
                     means_section(run);
  for (const std::string& mesh : mesh_names(run)) text += mesh_section(run, mesh);
  return text;
}

}  // namespace deltamesh::bench
