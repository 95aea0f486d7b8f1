// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codings that few streams have, for `core`: the module `rare` reads them.
#include "attributes/plain/plain.h"
#include "attributes/rare/rare.h"
#include "part.h"
#include "positions/positions.h"

namespace deltamesh {
namespace web {

DELTAMESH_OF_PART(rare, read_float_positions)
Result<std::vector<float>> read_float_positions_there(std::span<const std::byte> bytes, const FaceList& faces,
                                                      const Box& box);

DELTAMESH_OF_PART(rare, read_rare_values)
Result<std::vector<std::byte>> read_rare_values_there(AttributeCoding coding,
                                                      std::span<const std::byte> bytes,
                                                      const Attribute& shape, const AttributeSurface& surface,
                                                      std::span<const JointRow> joints);

DELTAMESH_OF_PART(rare, read_plain_values)
Result<std::vector<std::byte>> read_plain_values_there(std::span<const std::byte> payload,
                                                       const Attribute& shape, std::uint32_t rows);

}  // namespace web

Result<std::vector<float>> read_float_positions(std::span<const std::byte> bytes, const FaceList& faces,
                                                const Box& box) {
  return web::read_float_positions_there(bytes, faces, box);
}

Result<std::vector<std::byte>> read_rare_values(AttributeCoding coding, std::span<const std::byte> bytes,
                                                const Attribute& shape, const AttributeSurface& surface,
                                                std::span<const JointRow> joints,
                                                const Learning<AttributeModels>& /*none*/) {
  return web::read_rare_values_there(coding, bytes, shape, surface, joints);
}

Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows) {
  return web::read_plain_values_there(payload, shape, rows);
}

}  // namespace deltamesh
