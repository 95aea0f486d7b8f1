// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_reader.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "entropy/arrays.h"
#include "format/chunk/tags.h"
#include "highpass/plain/plain.h"

namespace deltamesh {

Result<LargeVector<std::int32_t>> read_plain_deltas(std::span<const std::byte> payload,
                                                    std::size_t vertices) {
  ByteReader in(payload, kTagDeltas);
  DELTAMESH_TRY(const auto codes, read_array(in, 3 * std::uint64_t{vertices}));
  DELTAMESH_CHECK(in.finish());
  LargeVector<std::int32_t> deltas(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) deltas[i] = unzigzag(codes[i]);
  return deltas;
}

Result<void> read_plain_anchors(std::span<const std::byte> payload, std::size_t vertices,
                                const HighpassParameters& parameters, HighpassSymbols& symbols) {
  ByteReader in(payload, kTagAnchors);
  DELTAMESH_TRY(const auto anchors, read_differences(in, parameters.anchors, 32));
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (anchors[i] >= vertices || (i > 0 && anchors[i] <= anchors[i - 1]))
      return in.invalid("anchors that do not ascend, or beyond the last vertex", "ANCH-3");
    symbols.anchors.push_back(static_cast<std::uint32_t>(anchors[i]));
  }
  symbols.cells.resize(anchors.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    DELTAMESH_TRY(const auto cells, read_differences(in, anchors.size(), 32));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i] >> parameters.anchor_bits != 0) return in.invalid("anchor outside its lattice", "ANCH-4");
      symbols.cells[i][axis] = static_cast<std::uint32_t>(cells[i]);
    }
  }
  return in.finish();
}

}  // namespace deltamesh
