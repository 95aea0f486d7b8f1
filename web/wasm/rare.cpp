// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `rare`, for codings that few streams have: exact positions, attributes on lattices and in
// plain form, joints and weights, colours at a mean error.
#include "attributes/rare/rare.h"

#include "attributes/plain/plain.h"
#include "part.h"
#include "positions/positions.h"

namespace deltamesh::web {

DELTAMESH_EXPORT(read_float_positions)
Result<std::vector<float>> read_float_positions_here(std::span<const std::byte> bytes, const FaceList& faces,
                                                     const Box& box) {
  return read_float_positions(bytes, faces, box);
}

DELTAMESH_EXPORT(read_rare_values)
Result<std::vector<std::byte>> read_rare_values_here(AttributeCoding coding, std::span<const std::byte> bytes,
                                                     const Attribute& shape, const AttributeSurface& surface,
                                                     std::span<const JointRow> joints) {
  return read_rare_values(coding, bytes, shape, surface, joints);
}

DELTAMESH_EXPORT(read_plain_values)
Result<std::vector<std::byte>> read_plain_values_here(std::span<const std::byte> payload,
                                                      const Attribute& shape, std::uint32_t rows) {
  return read_plain_values(payload, shape, rows);
}

}  // namespace deltamesh::web
