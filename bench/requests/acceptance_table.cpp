// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/acceptance_table.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "report/geometric_mean.h"

namespace deltamesh::bench {
namespace {

constexpr std::string_view kVoxelMaps[] = {"robot/kitchen_tsdf_20mm", "robot/kitchen_tsdf_10mm_half",
                                           "robot/kitti_lidar_tsdf_150mm", "robot/building_sim_50k",
                                           "robot/building_sim_250k"};
constexpr std::size_t kWorst = 5;

bool is_voxel_map(const std::string& mesh) {
  return std::find(std::begin(kVoxelMaps), std::end(kVoxelMaps), mesh) != std::end(kVoxelMaps);
}

const char* verdict(double value, double most) { return value <= most ? "kept" : "MISSED"; }

}  // namespace

void AcceptanceTable::add(std::string mesh, const std::vector<DracoPoint>& draco,
                          const std::vector<Result<RequestRow>>& rows) {
  Line line{.mesh = std::move(mesh), .cells = {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Cell cell;
    if (rows[i]) {
      cell.row = *rows[i];
      cell.ratio = static_cast<double>(cell.row.bytes) / static_cast<double>(draco[i].bytes);
      cell.quick_ratio = static_cast<double>(cell.row.quick_bytes) / static_cast<double>(draco[i].bytes);
    } else {
      cell.failure = rows[i].error().message;
    }
    line.cells.push_back(cell);
  }
  lines_.push_back(std::move(line));
}

void AcceptanceTable::print() const {
  std::printf("\n## Same %s\n\n| mesh |", criterion_.name);
  for (const int bits : bits_) std::printf(" qp %d |", bits);
  std::printf("\n|---|");
  for (std::size_t i = 0; i < bits_.size(); ++i) std::printf("---|");
  std::printf("\n");
  for (const Line& line : lines_) {
    std::printf("| %s |", line.mesh.c_str());
    for (const Cell& cell : line.cells) {
      if (cell.failure != nullptr) {
        std::printf(" %s |", cell.failure);
        continue;
      }
      std::printf(" %.3f %s%s%s |", cell.ratio, cell.row.geometry == "predictive" ? "p" : "h",
                  cell.row.agrees_at_effort_0 ? "" : "*", cell.row.kept ? "" : " EXCEEDED");
    }
    std::printf("\n");
  }
  print_means();
  if (criterion_.most_map) print_maps();
  print_worst();
  print_quick();
  std::fflush(stdout);
}

void AcceptanceTable::print_means() const {
  GeometricMean all;
  std::printf("| geometric mean |");
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    GeometricMean mean;
    for (const Line& line : lines_) {
      if (line.cells[i].failure != nullptr) continue;
      mean.add(line.cells[i].ratio);
      all.add(line.cells[i].ratio);
    }
    std::printf(" %.3f |", mean.value().value_or(0));
  }
  const double mean = all.value().value_or(0);
  std::printf("\n\nGeometric mean of all: %.3f, asked %.2f: %s.\n", mean, criterion_.most_mean,
              verdict(mean, criterion_.most_mean));
}

void AcceptanceTable::print_maps() const {
  for (const Line& line : lines_) {
    if (!is_voxel_map(line.mesh)) continue;
    GeometricMean mean;
    for (const Cell& cell : line.cells)
      if (cell.failure == nullptr) mean.add(cell.ratio);
    const double value = mean.value().value_or(0);
    std::printf("%s: %.3f, asked %.2f: %s.\n", line.mesh.c_str(), value, *criterion_.most_map,
                verdict(value, *criterion_.most_map));
  }
}

void AcceptanceTable::print_worst() const {
  struct Entry {
    double ratio;
    const Line* line;
    int bits;
  };
  std::vector<Entry> entries;
  for (const Line& line : lines_)
    for (std::size_t i = 0; i < bits_.size(); ++i)
      if (line.cells[i].failure == nullptr) entries.push_back({line.cells[i].ratio, &line, bits_[i]});
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.ratio > b.ratio; });
  std::printf("Largest, asked %.2f:", criterion_.most_single);
  for (std::size_t i = 0; i < std::min(kWorst, entries.size()); ++i)
    std::printf("%s %s at qp %d %.3f", i == 0 ? "" : ",", entries[i].line->mesh.c_str(), entries[i].bits,
                entries[i].ratio);
  if (!entries.empty()) std::printf(": %s.\n", verdict(entries.front().ratio, criterion_.most_single));
}

void AcceptanceTable::print_quick() const {
  GeometricMean quick;
  GeometricMean usual;
  GeometricMean lost;
  std::size_t agreed = 0;
  std::size_t count = 0;
  for (const Line& line : lines_) {
    for (const Cell& cell : line.cells) {
      if (cell.failure != nullptr) continue;
      ++count;
      quick.add(cell.quick_ratio);
      usual.add(cell.ratio);
      if (cell.row.agrees_at_effort_0)
        ++agreed;
      else
        lost.add(cell.quick_ratio / cell.ratio);
    }
  }
  std::printf(
      "Effort 0 chooses the same coder in %zu of %zu cases; its geometric mean is %.3f, that of the effort "
      "asked for %.3f.",
      agreed, count, quick.value().value_or(0), usual.value().value_or(0));
  if (agreed < count)
    std::printf(" Where it chooses the other it takes %.3f times the bytes.", lost.value().value_or(0));
  std::printf("\n");
}

}  // namespace deltamesh::bench
