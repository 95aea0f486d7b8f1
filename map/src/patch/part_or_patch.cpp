// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "patch/part_or_patch.h"

#include <xxhash.h>

#include <optional>
#include <vector>

#include "base/try.h"
#include "lattice/border_payload.h"
#include "lattice/known_base.h"
#include "lattice/place_border.h"
#include "patch/container.h"
#include "patch/payload.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

Result<MapPart> decode_opened(const MapCodec::State& state, const PartKey& key, const OpenedPart& opened,
                              const DecodeOptions& options, const MapPart* base = nullptr) {
  MapPart part;
  part.key = key;
  const CodecModels& models = opened.primer ? state.models[*opened.primer] : state.models.back();
  DecodeOptions of_stream = options;
  of_stream.starting_states = models.start();
  std::optional<KnownBase> known;
  if (base != nullptr) of_stream.known = known.emplace(*base).mesh();
  DELTAMESH_TRY(part.mesh, decode(opened.stream, of_stream));
  const MapLattice& lattice = state.description.lattice;
  DELTAMESH_TRY(const BorderView view, view_border(opened.stream, part.mesh, lattice, base));
  DELTAMESH_TRY(part.border, read_border(opened.border, part.mesh, view, {&models.border}));
  part.streamed_border = positions_of(part.mesh, part.border);
  part.mesh.origin = lattice.origin;
  place_border(part.mesh, part.border, lattice, view.follows);
  return part;
}

/// Of a patch.
Result<MapPart> decode_inserted(const MapCodec::State& state, const PartKey& key,
                                std::span<const std::byte> octets, const DecodeOptions& options,
                                const MapPart* base = nullptr) {
  DELTAMESH_TRY(const OpenedPart opened, open_covered_part(state.place_of(key, base), octets));
  return decode_opened(state, key, opened, options, base);
}

}  // namespace

Result<MapPart> apply_patch(const MapCodec::State& state, const PartKey& key, const MapPart& base,
                            std::uint64_t base_hash, std::span<const std::byte> body,
                            const DecodeOptions& options) {
  DELTAMESH_TRY(const PatchBody opened, open_body(state.place_of(key), base_hash, body));
  if (opened.plan.empty() && opened.inserted.empty()) return broken_patch("a patch without anything");
  if (opened.plan.empty()) return decode_inserted(state, key, opened.inserted, options, &base);
  MapPart inserted;
  if (!opened.inserted.empty()) {
    DELTAMESH_TRY(inserted, decode_inserted(state, key, opened.inserted, options));
  }
  if (!base.mesh.face_groups.empty() || !inserted.mesh.face_groups.empty())
    return broken_patch("a patch with groups of faces");
  DELTAMESH_TRY(const PatchPlan plan, read_patch_plan(opened.plan, base.mesh, inserted.mesh));
  return put_together(key, base, inserted, plan);
}

Result<MapPart> decode_part(const MapCodec::State& state, const PartKey& key,
                            std::span<const std::byte> octets, const DecodeOptions& options) {
  struct Patch {
    PartKey key;
    PatchedOctets octets;
  };
  std::vector<Patch> patches;  // the last one first
  PartKey of = key;
  for (; is_patched(octets); octets = patches.back().octets.base) {
    if (patches.size() == kMostPatches) return broken_patch("more than 16 patches");
    DELTAMESH_TRY(const PatchedOctets divided, divide_patched(octets));
    patches.push_back({of, divided});
    of = divided.base_key;
  }
  DELTAMESH_TRY(const OpenedPart whole, open_part(state.place_of(of), octets));
  DELTAMESH_TRY(MapPart part, decode_opened(state, of, whole, options));
  for (; !patches.empty(); patches.pop_back()) {
    const auto& [base_key, base, body] = patches.back().octets;
    const std::uint64_t hash = XXH3_64bits(base.data(), base.size());
    DELTAMESH_TRY(part, apply_patch(state, patches.back().key, part, hash, body, options));
    if (part.mesh.vertex_count() > options.limits.vertices)
      return Error{
          .code = ErrorCode::kLimitExceeded, .message = "more vertices than allowed", .rule = "MAP-17"};
  }
  return part;
}

}  // namespace deltamesh
