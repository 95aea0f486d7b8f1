// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/report.h"

#include <optional>
#include <utility>

#include "curves/equal_quality.h"
#include "curves/ladder.h"
#include "deltamesh/version.h"
#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"
#include "support/machine.h"

namespace deltamesh::bench {
namespace {

constexpr const char* kNone = "–";

std::string heading() {
  return table_head({"commit", "compiler", "flags", "CPU", "deltamesh", "Draco", "zstd"}, 7) +
         table_row({kBuildInfo.commit, kBuildInfo.compiler, join({"`", kBuildInfo.flags, "`"}),
                    processor_name(), kLibraryVersion, draco_version(), zstd_version()}) +
         '\n';
}

std::string explanation(const Run& run) {
  return join(
      {"Meshes: ", run.meshes,
       ". Every peer gets the same mesh: positions and triangles only, equal positions welded, degenerate "
       "faces and unused vertices dropped. One thread. Times are processor times, medians of up to ",
       std::to_string(run.timing.rounds), " runs (fewer where they take more than ",
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

std::string ratio_head(std::string_view first) {
  Cells names{std::string(first)};
  names.insert(names.end(), kReferenceSettings.begin(), kReferenceSettings.end());
  return table_head(names);
}

void add(RatioMeans& means, const Ratios& ratios) {
  for (std::size_t i = 0; i < means.size(); ++i)
    if (ratios[i]) means[i].add(ratios[i]->value);
}

std::string mean_row(std::string_view title, const RatioMeans& means) {
  Cells cells{join({"**", title, "**"})};
  for (const GeometricMean& mean : means)
    cells.push_back(join({"**", mean.value() ? fixed(*mean.value(), 3) : kNone, "**"}));
  return table_row(cells);
}

/// "robot" of "robot/kitchen".
std::string group_of(const std::string& mesh) { return mesh.substr(0, mesh.find('/')); }

std::string equal_quality_table(const Run& run, const ErrorKind& kind) {
  std::string text = join({"### Equal ", kind.name, "\n\n"}) + ratio_head("mesh");
  RatioMeans all;
  std::vector<std::pair<std::string, RatioMeans>> groups;
  for (const EqualQualityRow& row : equal_quality(run, kind, kOurName)) {
    Cells cells{row.mesh};
    for (const auto& ratio : row.ratios) cells.push_back(ratio_cell(ratio));
    text += table_row(cells);
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
      join({"### Every peer at equal ", kind.name, ", geometric means\n\n"}) + ratio_head("peer");
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
      "## Where the bytes go\n\n" + table_head({"mesh", "setting", "bytes", "connectivity %", "geometry %",
                                                "anchors %", "attributes %", "container %"},
                                               2);
  for (const Measurement& m : run.measurements) {
    if (!m.shares) continue;
    Cells cells{m.mesh, m.setting, number(m.bytes)};
    for (const std::uint64_t part : {m.shares->connectivity, m.shares->geometry, m.shares->anchors,
                                     m.shares->attributes, m.shares->container})
      cells.push_back(fixed(100 * ratio(part, m.bytes), 1));
    text += table_row(cells);
  }
  return text + '\n';
}

std::string mesh_section(const Run& run, const std::string& mesh) {
  std::string rows;
  std::string counts;
  for (const Measurement& m : run.measurements) {
    if (m.mesh != mesh) continue;
    counts = join({number(m.vertices), " vertices, ", number(m.triangles), " triangles"});
    const double per_vertex = 1e9 / static_cast<double>(m.vertices);
    rows +=
        table_row({m.peer, m.setting, number(m.bytes), significant(m.bits_per_vertex(), 4),
                   significant(m.percent(m.quality.vde_rms), 4), significant(m.percent(m.quality.lfe_rms), 4),
                   significant(m.percent(m.quality.max_error), 4), fixed(m.encode_seconds * per_vertex, 0),
                   fixed(m.decode_seconds * per_vertex, 0)});
  }
  return join({"## ", mesh, "\n\n", counts, "\n\n",
               table_head({"peer", "setting", "bytes", "bits per vertex", "VDE %", "LFE %", "max error %",
                           "encode ns per vertex", "decode ns per vertex"},
                          2),
               rows, "\n"});
}

std::string failure_section(const Run& run) {
  if (run.failures.empty()) return {};
  std::string text = "## Failed\n\n" + table_head({"mesh", "peer", "why"}, 3);
  for (const Failure& failure : run.failures) text += table_row({failure.mesh, failure.peer, failure.reason});
  return text + '\n';
}

}  // namespace

std::string render_markdown(const Run& run) {
  std::string text = "# deltamesh beside its peers\n\n" + heading() + explanation(run) +
                     failure_section(run) + equal_quality_section(run) + shares_section(run);
  for (const std::string& mesh : mesh_names(run)) text += mesh_section(run, mesh);
  return text;
}

std::string render_csv(const Run& run) {
  constexpr int kDigits = 9;
  std::string csv = csv_row({"mesh", "vertices", "triangles", "diagonal", "peer", "setting", "bytes",
                             "bits_per_vertex", "vde_rms", "lfe_rms", "max_error", "vde_percent",
                             "lfe_percent", "max_percent", "encode_seconds", "decode_seconds"});
  for (const Measurement& m : run.measurements) {
    const Quality& q = m.quality;
    Cells cells{quoted(m.mesh), number(m.vertices), number(m.triangles), significant(m.diagonal, kDigits),
                quoted(m.peer), quoted(m.setting),  number(m.bytes)};
    for (const double figure :
         {m.bits_per_vertex(), q.vde_rms, q.lfe_rms, q.max_error, m.percent(q.vde_rms), m.percent(q.lfe_rms),
          m.percent(q.max_error), m.encode_seconds, m.decode_seconds})
      cells.push_back(significant(figure, kDigits));
    csv += csv_row(cells);
  }
  return csv;
}

}  // namespace deltamesh::bench
