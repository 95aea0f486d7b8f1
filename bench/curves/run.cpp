// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/run.h"

#include <algorithm>

namespace deltamesh::bench {
namespace {

std::vector<std::string> distinct(const Run& run, std::string Measurement::*member) {
  std::vector<std::string> names;
  for (const Measurement& measurement : run.measurements)
    if (std::find(names.begin(), names.end(), measurement.*member) == names.end())
      names.push_back(measurement.*member);
  return names;
}

}  // namespace

std::vector<std::string> mesh_names(const Run& run) { return distinct(run, &Measurement::mesh); }

std::vector<std::string> peer_names(const Run& run) { return distinct(run, &Measurement::peer); }

}  // namespace deltamesh::bench
