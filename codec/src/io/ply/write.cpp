// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Binary little-endian PLY.
#include <array>
#include <set>
#include <string>
#include <utility>

#include "base/byte_writer.h"
#include "io/formats.h"
#include "io/ply/header.h"
#include "io/text/vertices.h"

namespace deltamesh {
namespace {

/// One scalar property of the vertices, apart from the position.
struct Column {
  std::string name;
  const AttributeView* attribute = nullptr;
  std::size_t component = 0;
};

/// A name that a PLY header can carry: no blanks, no control characters, not empty.
std::string ply_name(std::string_view name) {
  std::string clean(name.empty() ? "attribute" : name);
  for (char& c : clean)
    if (static_cast<unsigned char>(c) <= ' ' || c == 0x7f) c = '_';
  return clean;
}

class Columns {
 public:
  Columns(const MeshView& mesh, WriteReport& report) {
    const AttributeView* const normal = first_of(mesh, AttributeKind::kNormal, 3);
    const AttributeView* const color = first_of(mesh, AttributeKind::kColor, 3);
    const AttributeView* const uv = first_of(mesh, AttributeKind::kUv, 2);
    if (normal != nullptr) add_named(*normal, {"nx", "ny", "nz"}, 3);
    if (uv != nullptr) add_named(*uv, {"s", "t"}, 2);
    if (color != nullptr)
      add_named(*color, {"red", "green", "blue", "alpha"}, color->components >= 4 ? std::size_t{4} : 3);
    for (const AttributeView& attribute : mesh.attributes)
      if (&attribute != normal && &attribute != color && &attribute != uv && !add_generic(attribute))
        report.leave_out(LeftOutKind::kNames, attribute.name);
  }

  std::vector<Column> take() { return std::move(columns_); }

 private:
  /// Whether the name could stay as it is.
  bool add(const std::string& name, const AttributeView& attribute, std::size_t component) {
    std::string unique = name;
    while (!used_.insert(unique).second) unique += '_';
    columns_.push_back({unique, &attribute, component});
    return unique == name;
  }
  void add_named(const AttributeView& attribute, const std::array<const char*, 4>& names, std::size_t count) {
    for (std::size_t c = 0; c < count; ++c) add(names[c], attribute, c);
  }
  bool add_generic(const AttributeView& attribute) {
    const std::string name = ply_name(attribute.name);
    bool same = name == attribute.name;
    for (std::size_t c = 0; c < attribute.components; ++c)
      same &= add(attribute.components == 1 ? name : name + '_' + std::to_string(c), attribute, c);
    return same;
  }

  std::set<std::string> used_{"x", "y", "z"};
  std::vector<Column> columns_;
};

std::string header_text(const MeshView& mesh, const std::vector<Column>& columns, bool wide) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  append_number(text, mesh.vertex_count());
  text += '\n';
  for (const char* axis : {"x", "y", "z"})
    text += std::string("property ") + (wide ? "double " : "float ") + axis + '\n';
  for (const Column& column : columns)
    text.append("property ")
        .append(kPlyTypes[static_cast<std::size_t>(column.attribute->type)])
        .append(" " + column.name + '\n');
  text += "element face ";
  append_number(text, mesh.triangle_count());
  // Signed where that suffices: some readers know no other indices.
  text += mesh.vertex_count() > 0x7fffffff ? "\nproperty list uchar uint vertex_indices\nend_header\n"
                                           : "\nproperty list uchar int vertex_indices\nend_header\n";
  return text;
}

/// Values lie in memory as in the file (base/machine.h).
void write_component(ByteWriter& out, const Column& column, std::size_t vertex) {
  const AttributeView& attribute = *column.attribute;
  const std::size_t size = component_size(attribute.type);
  out.write_bytes(attribute.values.subspan((vertex * attribute.components + column.component) * size, size));
}

}  // namespace

std::vector<std::byte> write_ply(const MeshView& mesh, WriteReport& report) {
  leave_out_groups(mesh, report);
  const bool wide = has_origin(mesh);
  const std::vector<Column> columns = Columns(mesh, report).take();
  ByteWriter out;
  const std::string header = header_text(mesh, columns, wide);
  out.write_bytes(std::as_bytes(std::span(header)));
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (wide)
        out.write(world_coordinate(mesh, v, k));
      else
        out.write(mesh.positions[3 * v + k]);
    }
    for (const Column& column : columns) write_component(out, column, v);
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    out.write(std::uint8_t{3});
    for (std::size_t k = 0; k < 3; ++k) out.write(mesh.triangles[3 * t + k]);
  }
  return out.take();
}

}  // namespace deltamesh
