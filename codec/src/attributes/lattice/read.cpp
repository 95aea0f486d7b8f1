// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/lattice/group.h"
#include "attributes/lattice/lattice.h"
#include "base/broken_rule.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// The numbers of one group.
Result<std::vector<Cell>> read_group(CompactReader& reader, const FieldFaces& over, const FieldGroup& group,
                                     std::span<const ComponentLattice> lattices, std::size_t count) {
  const bool is_floats = lattices[group.front()].is_floats();
  GroupForm form = form_of(group, lattices);
  std::vector<Cell> cells(count, form.rest);
  if (is_floats ? code_ordinals(reader, over, float_units(group, lattices), {}, cells)
                : code_numbers(reader, over, form, cells))
    return cells;
  if (reader.failed()) DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return is_floats ? broken_rule("not a finite float32", "FLT-1", kTagAttribute)
                   : broken_rule("an attribute's number is beyond its lattice", "ATTR-56", kTagAttribute);
}

}  // namespace

Result<std::vector<std::byte>> read_lattice(std::span<const std::byte> bytes, const Attribute& shape,
                                            const AttributeSurface& surface) {
  ByteReader in(bytes, kTagAttribute);
  std::vector<ComponentLattice> lattices;
  for (std::size_t c = 0; c < shape.components; ++c) {
    DELTAMESH_TRY(const auto lattice,
                  read_lattice_fields(in, shape.type, c > 0 ? &lattices.back() : nullptr));
    lattices.push_back(lattice);
  }
  const auto groups = field_groups(lattices);
  LatticeValues values(shape.type, lattices, surface.vertex_count());
  if (groups.empty()) {
    DELTAMESH_CHECK(in.finish());
    return values.take();
  }
  DELTAMESH_TRY(const auto coded, in.read_bytes(in.remaining()));
  CompactReader reader(coded);
  const FieldFaces over(surface, reader.bits(0, 1) != 0);
  for (const FieldGroup& group : groups) {
    DELTAMESH_TRY(const auto cells, read_group(reader, over, group, lattices, surface.vertex_count()));
    values.set_group(group, cells);
  }
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return values.take();
}

}  // namespace deltamesh
