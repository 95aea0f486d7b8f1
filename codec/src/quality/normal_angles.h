// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Mean and percentile of the angles between normals.
#pragma once

#include <vector>

#include "base/vec3.h"
#include "deltamesh/compare.h"

namespace deltamesh {

/// Gathers angles; pairs without a direction are left out.
class NormalAngles {
 public:
  void add(const Vec3& a, const Vec3& b);
  /// Sets mean and 95th percentile; not twice.
  void report(Comparison& result);

 private:
  std::vector<double> degrees_;
};

}  // namespace deltamesh
