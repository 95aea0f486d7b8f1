// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Our bytes over Draco's at one kind of equal error, mesh by mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "requests/rows.h"

namespace deltamesh::bench {

/// What is asked for of Draco's figures.
struct Criterion {
  const char* name;
  QualityRequest (*request)(const Quality& draco);
};

/// Draco's figures at one number of bits.
struct DracoPoint {
  std::uint64_t bytes = 0;
  Quality quality{};
};

class ErrorTable {
 public:
  ErrorTable(const Criterion& criterion, std::vector<int> bits)
      : criterion_(criterion), bits_(std::move(bits)) {}

  const Criterion& criterion() const noexcept { return criterion_; }

  /// `rows`: one for each number of bits.
  void add(const std::string& mesh, const std::vector<DracoPoint>& draco,
           const std::vector<Result<RequestRow>>& rows);

  /// Markdown: the rows, geometric means, those of maps from voxels, the worst, and what effort 0 does.
  std::string markdown() const;

 private:
  struct Cell {
    std::string mesh;
    std::size_t column = 0;
    double ratio = 0;
    double quick_ratio = 0;  ///< at effort 0
    RequestRow row{};
    const char* failure = nullptr;  ///< why there are no figures
  };

  std::string rows() const;
  std::string maps() const;
  std::string worst() const;
  std::string quick() const;

  Criterion criterion_;
  std::vector<int> bits_;
  std::vector<Cell> cells_;  ///< mesh by mesh
};

}  // namespace deltamesh::bench
