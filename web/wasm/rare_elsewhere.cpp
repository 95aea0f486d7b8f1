// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codings that few streams have, for `core`: the module `rare` reads them.
#include "attributes/lattice/lattice.h"
#include "attributes/plain/plain.h"
#include "attributes/skin/skin.h"
#include "base/try.h"
#include "parts.h"
#include "positions/positions.h"

namespace deltamesh {
namespace {

using web::RareCall;
using web::RareForm;

template <class Array>
web::HandedArray hand_over(const Array& array) {
  return web::hand_over(web::Part::kRare, array);
}

/// What `call` returns, one array.
template <class Vector>
Result<Vector> read(const RareCall& call) {
  DELTAMESH_TRY(const auto returned, web::call_part(web::Part::kRare, call));
  Vector values;
  web::take_array(web::Part::kRare, returned.arrays[0], values);
  return values;
}

Result<std::vector<std::byte>> read_values(RareForm form, std::span<const std::byte> bytes,
                                           const Attribute& shape, const AttributeSurface& surface,
                                           std::span<const JointRow> joints = {}) {
  return read<std::vector<std::byte>>({.form = form,
                                       .vertex_count = surface.vertex_count(),
                                       .bytes = hand_over(bytes),
                                       .triangles = hand_over(surface.triangles()),
                                       .geometric = hand_over(surface.geometric()),
                                       .joints = hand_over(joints),
                                       .kind = shape.kind,
                                       .type = shape.type,
                                       .components = shape.components});
}

}  // namespace

Result<std::vector<float>> read_float_positions(std::span<const std::byte> bytes, const FaceList& faces,
                                                const Box& box) {
  return read<std::vector<float>>({.form = RareForm::kPositions,
                                   .vertex_count = faces.vertex_count,
                                   .bytes = hand_over(bytes),
                                   .triangles = hand_over(faces.triangles),
                                   .box = box});
}

Result<std::vector<std::byte>> read_lattice(std::span<const std::byte> bytes, const Attribute& shape,
                                            const AttributeSurface& surface) {
  return read_values(RareForm::kLattice, bytes, shape, surface);
}

Result<std::vector<std::byte>> read_joints(std::span<const std::byte> bytes, const Attribute& shape,
                                           const AttributeSurface& surface) {
  return read_values(RareForm::kJoints, bytes, shape, surface);
}

Result<std::vector<std::byte>> read_weights(std::span<const std::byte> bytes, const Attribute& shape,
                                            const AttributeSurface& surface,
                                            std::span<const JointRow> joints) {
  return read_values(RareForm::kWeights, bytes, shape, surface, joints);
}

Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows) {
  return read<std::vector<std::byte>>({.form = RareForm::kPlain,
                                       .vertex_count = rows,
                                       .bytes = hand_over(payload),
                                       .kind = shape.kind,
                                       .type = shape.type,
                                       .components = shape.components});
}

}  // namespace deltamesh
