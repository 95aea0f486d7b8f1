// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/error_table.h"

#include <algorithm>
#include <string_view>

#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

constexpr std::string_view kVoxelMaps[] = {"robot/building_sim_250k", "robot/building_sim_50k",
                                           "robot/kitchen_tsdf_10mm_half", "robot/kitchen_tsdf_20mm",
                                           "robot/kitti_lidar_tsdf_150mm"};
constexpr std::size_t kWorst = 5;

std::string three(double value) { return fixed(value, 3); }
std::string three(const GeometricMean& mean) { return three(mean.value().value_or(0)); }

}  // namespace

void ErrorTable::add(const std::string& mesh, const std::vector<DracoPoint>& draco,
                     const std::vector<Result<RequestRow>>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Cell cell{.mesh = mesh, .column = i};
    if (rows[i]) {
      cell.row = *rows[i];
      cell.ratio = ratio(cell.row.bytes, draco[i].bytes);
      cell.quick_ratio = ratio(cell.row.quick_bytes, draco[i].bytes);
    } else {
      cell.failure = rows[i].error().message;
    }
    cells_.push_back(cell);
  }
}

std::string ErrorTable::markdown() const {
  return join({"\n## Same ", criterion_.name, "\n\n"}) + rows() + maps() + worst() + quick();
}

std::string ErrorTable::rows() const {
  Cells names{"mesh"};
  for (const int bits : bits_) names.push_back("qp " + number(bits));
  std::string text = table_head(names);
  std::vector<GeometricMean> means(bits_.size());
  GeometricMean all;
  Cells line;
  for (const Cell& cell : cells_) {
    if (cell.column == 0) line = {cell.mesh};
    line.push_back(cell.failure != nullptr
                       ? cell.failure
                       : join({three(cell.ratio), cell.row.geometry == "highpass" ? " h" : " p",
                               cell.row.agrees_at_effort_0 ? "" : "*", cell.row.kept ? "" : " EXCEEDED"}));
    if (cell.column + 1 == bits_.size()) text += table_row(line);
    if (cell.failure != nullptr) continue;
    means[cell.column].add(cell.ratio);
    all.add(cell.ratio);
  }
  line = {"geometric mean"};
  for (const GeometricMean& mean : means) line.push_back(three(mean));
  return text + table_row(line) + join({"\nGeometric mean of all: ", three(all), ".\n"});
}

std::string ErrorTable::maps() const {
  std::string text;
  for (const std::string_view map : kVoxelMaps) {
    GeometricMean mean;
    for (const Cell& cell : cells_)
      if (cell.mesh == map && cell.failure == nullptr) mean.add(cell.ratio);
    if (mean.value()) text += join({text.empty() ? "Maps from voxels: " : ", ", map, " ", three(mean)});
  }
  return text.empty() ? text : text + ".\n";
}

std::string ErrorTable::worst() const {
  std::vector<Cell> cells = cells_;
  std::erase_if(cells, [](const Cell& cell) { return cell.failure != nullptr; });
  std::ranges::stable_sort(cells, std::ranges::greater{}, &Cell::ratio);
  cells.resize(std::min(kWorst, cells.size()));
  std::string text;
  for (const Cell& cell : cells)
    text += join({text.empty() ? "Largest: " : ", ", cell.mesh, " at qp ", number(bits_[cell.column]), " ",
                  three(cell.ratio)});
  return text + ".\n";
}

std::string ErrorTable::quick() const {
  GeometricMean quick;
  GeometricMean usual;
  GeometricMean lost;
  std::size_t agreed = 0;
  std::size_t count = 0;
  for (const Cell& cell : cells_) {
    if (cell.failure != nullptr) continue;
    ++count;
    quick.add(cell.quick_ratio);
    usual.add(cell.ratio);
    agreed += cell.row.agrees_at_effort_0 ? 1 : 0;
    if (!cell.row.agrees_at_effort_0) lost.add(cell.quick_ratio / cell.ratio);
  }
  std::string text = join({"Effort 0 chooses the same coder in ", number(agreed), " of ", number(count),
                           " cases; its geometric mean is ", three(quick), ", that of the effort asked for ",
                           three(usual), "."});
  if (agreed < count)
    text += join({" Where it chooses the other it takes ", three(lost), " times the bytes."});
  return text + "\n";
}

}  // namespace deltamesh::bench
