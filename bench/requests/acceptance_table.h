// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Our bytes over Draco's at one kind of equal error, mesh by mesh, and how they stand to what is asked of
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "requests/request_rows.h"

namespace deltamesh::bench {

/// What is compared, and the most that is asked for.
struct Criterion {
  const char* name;
  QualityRequest (*request)(const Quality& draco);
  double most_mean;                ///< geometric mean over meshes and bits
  double most_single;              ///< every mesh at every number of bits
  std::optional<double> most_map;  ///< geometric mean of each map from voxels
};

/// Draco's figures at one number of bits.
struct DracoPoint {
  std::uint64_t bytes = 0;
  Quality quality{};
};

class AcceptanceTable {
 public:
  AcceptanceTable(const Criterion& criterion, std::vector<int> bits)
      : criterion_(criterion), bits_(std::move(bits)) {}

  const Criterion& criterion() const noexcept { return criterion_; }

  /// `rows`: one for each number of bits.
  void add(std::string mesh, const std::vector<DracoPoint>& draco,
           const std::vector<Result<RequestRow>>& rows);

  /// Markdown on stdout: the rows, geometric means, the worst, and what effort 0 does.
  void print() const;

 private:
  struct Cell {
    double ratio = 0;
    double quick_ratio = 0;  ///< at effort 0
    RequestRow row{};
    const char* failure = nullptr;  ///< why there are no figures
  };
  struct Line {
    std::string mesh;
    std::vector<Cell> cells;
  };

  void print_means() const;
  void print_maps() const;
  void print_worst() const;
  void print_quick() const;

  Criterion criterion_;
  std::vector<int> bits_;
  std::vector<Line> lines_;
};

}  // namespace deltamesh::bench
