// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OFF text, with the prefixes ST, C and N for what the vertices carry.
#include <string>

#include "io/formats.h"
#include "io/text/vertices.h"

namespace deltamesh {
namespace {

/// Bytes as whole numbers, anything else as real numbers with a point, which is how readers tell them apart.
void append_color(std::string& out, const AttributeView& color, std::size_t vertex) {
  const std::size_t count = color.components >= 4 ? 4 : 3;
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t at = (vertex * color.components + c) * component_size(color.type);
    out += ' ';
    if (color.type == ComponentType::kU8) {
      append_number(out, std::to_integer<unsigned>(color.values[at]));
      continue;
    }
    const std::size_t before = out.size();
    append_number(out, to_float(attribute_value(color, vertex, c)));
    if (out.find_first_of(".en", before) == out.npos) out += ".0";
  }
}

}  // namespace

std::vector<std::byte> write_off(const MeshView& mesh, WriteReport& report) {
  const auto [normal, color, uv] = choose_values(mesh, report);
  leave_out_groups(mesh, report);
  std::string out;
  if (uv != nullptr) out += "ST";
  if (color != nullptr) out += 'C';
  if (normal != nullptr) out += 'N';
  out += "OFF\n";
  append_number(out, mesh.vertex_count());
  out += ' ';
  append_number(out, mesh.triangle_count());
  out += " 0\n";
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    append_position(out, mesh, v);
    if (normal != nullptr) append_values(out, *normal, v, 3);
    if (color != nullptr) append_color(out, *color, v);
    if (uv != nullptr) append_values(out, *uv, v, 2);
    out += '\n';
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    out += '3';
    for (std::size_t k = 0; k < 3; ++k) {
      out += ' ';
      append_number(out, mesh.triangles[3 * t + k]);
    }
    out += '\n';
  }
  const auto bytes = std::as_bytes(std::span(out));
  return {bytes.begin(), bytes.end()};
}

}  // namespace deltamesh
