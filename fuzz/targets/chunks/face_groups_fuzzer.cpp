// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// FGRP payloads from anywhere. The last two bytes are the vertex count (and 128 for the compact form) and the
// face count. What is read must come back unchanged from both forms.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "connectivity/groups/groups.h"
#include "connectivity/plain/topology.h"
#include "goal.h"
#include "meshes.h"

namespace {

using namespace deltamesh;

fuzz::Goal plain_groups("the plain form");
fuzz::Goal compact_groups("the compact form");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const fuzz::SpreadFaces spread(data[size - 2], data[size - 1]);
  const auto& [vertices, faces, triangles, geometric] = spread;
  const auto payload = std::as_bytes(std::span(data, size - 2));
  const bool is_compact = data[size - 2] >= 128;
  const auto groups =
      is_compact ? read_face_groups(payload, triangles, vertices) : read_plain_groups(payload, faces);
  if (!fuzz::check(groups)) return 0;
  if (!groups->empty() && groups->size() != faces) std::abort();
  if (std::ranges::any_of(*groups, [](std::uint32_t g) { return g >= kMostGroups; })) std::abort();
  const auto again = read_face_groups(write_face_groups(*groups, triangles, vertices), triangles, vertices);
  if (!again || *again != *groups) std::abort();
  const auto plain = read_plain_groups(write_plain_groups(*groups), faces);
  if (!plain || *plain != *groups) std::abort();
  (is_compact ? compact_groups : plain_groups).reach();
  return 0;
}
