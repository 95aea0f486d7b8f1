// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How many bytes a peer needs for the error that the reference peer makes, as a share of its bytes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "curves/run.h"

namespace deltamesh::bench {

/// The reference's settings that are compared.
inline constexpr std::array<const char*, 4> kReferenceSettings = {"qp 9", "qp 10", "qp 11", "qp 12"};

struct SizeRatio {
  double value = 0;  ///< the peer's bytes / the reference's
  bool is_upper_bound =
      false;  ///< even the peer's coarsest setting has a smaller error: the true ratio is lower
};

struct EqualQualityRow {
  std::string mesh;
  std::array<std::optional<SizeRatio>, kReferenceSettings.size()>
      ratios;  ///< nothing: no setting of the peer reaches it
};

/// A row for every mesh; the bytes of `peer` come from the lower hull of all its settings.
std::vector<EqualQualityRow> equal_quality(const Run& run, const ErrorKind& kind, std::string_view peer);

}  // namespace deltamesh::bench
