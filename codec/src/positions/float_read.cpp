// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/try.h"
#include "positions/floats/coder.h"
#include "positions/lattice/coder.h"
#include "positions/ordered_read.h"
#include "positions/positions.h"

namespace deltamesh {
namespace {

Result<std::vector<float>> read_floats(CompactReader& reader, const KnownFaces& faces,
                                       const BlendTable& blends, const Box& box) {
  FloatCoder coder(reader, faces, float_units(box), blends);
  LargeVector<Ordinals> floats(faces.vertex_count(), Ordinals{});
  for (std::uint32_t v = 0; v < floats.size() && !reader.failed(); ++v) {
    const char* broken = coder.code_vertex(v, floats);
    if (broken != nullptr && !reader.failed()) return broken_positions("not a finite float32", broken);
  }
  DELTAMESH_CHECK(reader.finish(kTagPositions));
  return to_rows(floats.size(), [&](std::size_t v, std::size_t axis) { return float_of(floats[v][axis]); });
}

}  // namespace

Result<std::vector<float>> read_float_positions(std::span<const std::byte> bytes, const FaceList& list,
                                                const Box& box) {
  return read_in_order(
      bytes, [&](CompactReader& reader, CodingOrder coding_order, std::vector<std::uint32_t>& order) {
        const KnownFaces faces = known_in_order(list, coding_order, order);
        BlendTable blends{};
        code_blends(reader, blends);
        return read_floats(reader, faces, blends, box);
      });
}

}  // namespace deltamesh
