// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/coder/writer.h"
#include "lattice/border_payload.h"
#include "lattice/border_payload_colors.h"

namespace deltamesh {

std::vector<std::byte> write_border(Mesh& mesh, const BorderView& view, std::vector<BorderVertex> border,
                                    const BorderModels& start, std::span<const BorderColors> colors) {
  if (border.empty()) return {};
  const OpenEdges edges(mesh.triangles, mesh.vertex_count());
  CompactWriter writer;
  BorderModels models = start;
  BorderCoder coder(writer, models, view, edges);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) coder.code(v, border, next);
  code_all_colors(writer, models.colors, mesh, border, colors);
  return writer.finish();
}

}  // namespace deltamesh
