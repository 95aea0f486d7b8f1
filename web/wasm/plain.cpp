// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `plain`, for chunks in their plain form, and for what zstd coded.
#include "attributes/plain/plain.h"

#include <optional>
#include <utility>
#include <vector>

#include "base/try.h"
#include "connectivity/plain_forms.h"
#include "entropy/zstd_frame.h"
#include "part.h"

namespace deltamesh::web {
namespace {

struct Kept {
  ManifoldFaces faces;
  CornerCopies copies;
  MeshOrder order;
  std::vector<std::uint32_t> groups;
  std::vector<std::byte> bytes;
  PartOutcome outcome;
};
std::optional<Kept> kept;

/// Returns `arrays`, in order, which stay where they are.
template <class... Arrays>
void hand_back(const Arrays&... arrays) {
  (kept->outcome.returned.add(arrays), ...);
}

Result<void> read(const PlainCall& call, std::span<const std::byte> bytes) {
  const auto [first, second] = call.counts;
  switch (call.form) {
    case PlainForm::kFrame: {
      kept->bytes.resize(first);
      if (expand_frame(bytes, kept->bytes)) hand_back(kept->bytes);
      break;
    }
    case PlainForm::kFaces: {
      DELTAMESH_TRY(kept->faces, read_plain_faces(bytes, first, second));
      hand_back(kept->faces.triangles, kept->faces.open_edges, kept->faces.starts, kept->faces.vertex);
      break;
    }
    case PlainForm::kCopies: {
      const auto triangles = take_array<std::vector<std::uint32_t>>(call.triangles);
      DELTAMESH_TRY(kept->copies, read_plain_copies(bytes, triangles, first, second));
      hand_back(kept->copies.of_vertex, kept->copies.of_corner);
      break;
    }
    case PlainForm::kGroups: {
      DELTAMESH_TRY(kept->groups, read_plain_groups(bytes, first));
      hand_back(kept->groups);
      break;
    }
    case PlainForm::kOrder: {
      DELTAMESH_TRY(kept->order, read_plain_order(bytes, first, second));
      hand_back(kept->order.vertices, kept->order.faces, kept->order.rotation);
      break;
    }
    case PlainForm::kValues: {
      const Attribute shape{.kind = call.kind, .type = call.type, .components = call.components};
      DELTAMESH_TRY(kept->bytes, read_plain_values(bytes, shape, first));
      hand_back(kept->bytes);
      break;
    }
  }
  return {};
}

}  // namespace

extern "C" {

/// Releases `handed` and its arrays. The outcome lives until the next call, or until forget().
DELTAMESH_EXPORT(call) PartOutcome* call(PlainCall* handed) {
  const PlainCall call = *handed;
  release(handed);
  const auto bytes = take_array<std::vector<std::byte>>(call.bytes);
  kept.emplace();
  if (const auto done = read(call, bytes); !done) kept->outcome.error = outcome_of(done.error());
  return &kept->outcome;
}

DELTAMESH_EXPORT(forget) void forget() { kept.reset(); }

}  // extern "C"
}  // namespace deltamesh::web
