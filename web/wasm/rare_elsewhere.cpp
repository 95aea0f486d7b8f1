// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codings that few streams have, for `core`: the module `rare` reads them.
#include "attributes/plain/plain.h"
#include "attributes/rare/rare.h"
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

}  // namespace

Result<std::vector<float>> read_float_positions(std::span<const std::byte> bytes, const FaceList& faces,
                                                const Box& box) {
  return read<std::vector<float>>({.form = RareForm::kPositions,
                                   .vertex_count = faces.vertex_count,
                                   .bytes = hand_over(bytes),
                                   .triangles = hand_over(faces.triangles),
                                   .box = box});
}

Result<std::vector<std::byte>> read_rare_values(AttributeCoding coding, std::span<const std::byte> bytes,
                                                const Attribute& shape, const AttributeSurface& surface,
                                                std::span<const JointRow> joints,
                                                const Learning<AttributeModels>&) {
  return read<std::vector<std::byte>>({.form = RareForm::kAttribute,
                                       .vertex_count = surface.vertex_count(),
                                       .bytes = hand_over(bytes),
                                       .triangles = hand_over(surface.triangles()),
                                       .geometric = hand_over(surface.geometric()),
                                       .positions = hand_over(surface.positions()),
                                       .joints = hand_over(joints),
                                       .coding = coding,
                                       .kind = shape.kind,
                                       .type = shape.type,
                                       .components = shape.components});
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
