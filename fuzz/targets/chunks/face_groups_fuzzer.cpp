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

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  if (size < 2) return 0;
  const std::uint32_t vertices = data[size - 2] % 128U;
  const std::uint32_t faces = vertices == 0 ? 0 : data[size - 1];
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t corner = 0; corner < 3 * faces; ++corner)
    triangles.push_back((corner / 3 + corner % 3 * (1 + faces % 7)) % vertices);
  Payload payload(std::as_bytes(std::span(data, size - 2)));
  payload.is_compact = data[size - 2] >= 128;
  const auto groups = read_face_groups(payload, triangles, vertices);
  if (!groups) {
    if (groups.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (!groups->empty() && groups->size() != faces) std::abort();
  if (std::ranges::any_of(*groups, [](std::uint32_t g) { return g >= kMostGroups; })) std::abort();
  const CodedFaceGroups coded = write_face_groups(*groups, triangles, vertices);
  for (const Payload& form : {Payload(coded.payload), Payload::compact(coded.compact)}) {
    const auto again = read_face_groups(form, triangles, vertices);
    if (!again || *again != *groups) std::abort();
  }
  return 0;
}
