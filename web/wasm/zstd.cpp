// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `zstd`, for what zstd coded.
#include <optional>
#include <vector>

#include "entropy/zstd_frame.h"
#include "part.h"

namespace deltamesh::web {
namespace {

struct Kept {
  std::vector<std::byte> bytes;
  PartOutcome outcome;
};
std::optional<Kept> kept;

}  // namespace

extern "C" {

/// Releases `handed` and its array. Returns the expanded bytes, or no array where they are not one frame of
/// that size. The outcome lives until the next call, or until forget().
DELTAMESH_EXPORT(call) PartOutcome* call(ZstdCall* handed) {
  const ZstdCall call = *handed;
  release(handed);
  const auto frame = take_array<std::vector<std::byte>>(call.frame);
  kept.emplace().bytes.resize(call.expanded_bytes);
  if (expand_frame(frame, kept->bytes)) kept->outcome.returned.add(kept->bytes);
  return &kept->outcome;
}

DELTAMESH_EXPORT(forget) void forget() { kept.reset(); }

}  // extern "C"
}  // namespace deltamesh::web
