// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `rare`, for codings that few streams have: exact positions, attributes on lattices and in
// plain form, joints and weights, colours at a mean error.
#include "attributes/rare/rare.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "attributes/plain/plain.h"
#include "base/try.h"
#include "part.h"
#include "positions/positions.h"

namespace deltamesh::web {
namespace {

using Indices = std::vector<std::uint32_t>;
using Places = std::vector<float>;

/// What attributes of a stream share.
struct Faces {
  Faces(Indices of_mesh, Indices of_vertices, Places of_both, std::uint32_t count)
      : triangles(std::move(of_mesh)),
        geometric(std::move(of_vertices)),
        places(std::move(of_both)),
        surface(triangles, count, geometric, places) {}

  bool is(const Indices& of_mesh, const Indices& of_vertices, const Places& of_both,
          std::uint32_t count) const {
    return surface.vertex_count() == count && triangles == of_mesh && geometric == of_vertices &&
           places == of_both;
  }

  const Indices triangles;
  const Indices geometric;
  const Places places;
  const AttributeSurface surface;
};

std::optional<Faces> faces;  ///< of the last attribute: the next has mostly the same
std::vector<float> positions;
std::vector<std::byte> values;
PartOutcome outcome;

const AttributeSurface& surface_of(const RareCall& call) {
  auto triangles = take_array<Indices>(call.triangles);
  auto geometric = take_array<Indices>(call.geometric);
  auto places = take_array<Places>(call.positions);
  if (!faces || !faces->is(triangles, geometric, places, call.vertex_count))
    faces.emplace(std::move(triangles), std::move(geometric), std::move(places), call.vertex_count);
  return faces->surface;
}

Result<void> read_positions_of(const RareCall& call, std::span<const std::byte> bytes) {
  const auto triangles = take_array<Indices>(call.triangles);
  DELTAMESH_TRY(positions, read_float_positions(bytes, {triangles, call.vertex_count}, call.box));
  outcome.returned.add(positions);
  return {};
}

Result<void> read_values_of(const RareCall& call, std::span<const std::byte> bytes) {
  const Attribute shape{
      .kind = call.kind, .type = call.type, .components = static_cast<std::uint8_t>(call.components)};
  const auto read = [&] {
    if (call.form == RareForm::kPlain) return read_plain_values(bytes, shape, call.vertex_count);
    const AttributeSurface& surface = surface_of(call);
    const auto joints = take_array<std::vector<JointRow>>(call.joints);
    return read_rare_values(call.coding, bytes, shape, surface, joints);
  };
  DELTAMESH_TRY(values, read());
  outcome.returned.add(values);
  return {};
}

}  // namespace

extern "C" {

/// Releases `handed` and its arrays. The outcome lives until the next call, or until forget().
DELTAMESH_EXPORT(call) PartOutcome* call(RareCall* handed) {
  const RareCall call = *handed;
  release(handed);
  const auto bytes = take_array<std::vector<std::byte>>(call.bytes);
  outcome = {};
  const auto done =
      call.form == RareForm::kPositions ? read_positions_of(call, bytes) : read_values_of(call, bytes);
  if (!done) outcome.error = outcome_of(done.error());
  return &outcome;
}

DELTAMESH_EXPORT(forget) void forget() {
  faces.reset();
  positions = {};
  values = {};
}

}  // extern "C"
}  // namespace deltamesh::web
