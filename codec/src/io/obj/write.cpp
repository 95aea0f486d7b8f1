// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OBJ text. Colours follow the position on its line, as many programs read them.
#include <string>
#include <vector>

#include "io/formats.h"
#include "io/names.h"
#include "io/text/vertices.h"

namespace deltamesh {
namespace {

void append_records(std::string& out, const char* keyword, const AttributeView& attribute, std::size_t count,
                    std::size_t vertices) {
  for (std::size_t v = 0; v < vertices; ++v) {
    out += keyword;
    append_values(out, attribute, v, count);
    out += '\n';
  }
}

/// "i", "i/i", "i//i" or "i/i/i": all records of a vertex have its index.
void append_corner(std::string& out, std::uint64_t vertex, bool uv, bool normal) {
  const std::uint64_t index = vertex + 1;
  append_number(out, index);
  if (uv || normal) out += '/';
  if (uv) append_number(out, index);
  if (!normal) return;
  out += '/';
  append_number(out, index);
}

/// The statements that lead from the names `now` to `name`.
void change_group(std::string& out, const GroupName& name, GroupName& now) {
  const auto change = [&](const char* keyword, std::string GroupName::*level) {
    if (name.*level == now.*level) return;
    out += keyword;
    if (!(name.*level).empty()) out += ' ' + name.*level;
    out += '\n';
  };
  change("o", &GroupName::object);
  change("g", &GroupName::group);
  change("usemtl", &GroupName::material);
  now = name;
}

}  // namespace

std::vector<std::byte> write_obj(const MeshView& mesh, WriteReport& report) {
  const auto [normal, color, uv] = choose_values(mesh, report);
  if (color != nullptr && color->components > 3)
    report.leave_out(LeftOutKind::kVertexValues, "alpha", mesh.vertex_count());
  std::string out;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    out += "v ";
    append_position(out, mesh, v);
    if (color != nullptr) append_values(out, *color, v, 3);
    out += '\n';
  }
  if (uv != nullptr) append_records(out, "vt", *uv, 2, mesh.vertex_count());
  if (normal != nullptr) append_records(out, "vn", *normal, 3, mesh.vertex_count());
  const std::vector<GroupName> names = distinct_names(mesh);
  GroupName now;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!names.empty()) change_group(out, names[mesh.face_groups.empty() ? 0 : mesh.face_groups[t]], now);
    out += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      out += ' ';
      append_corner(out, mesh.triangles[3 * t + k], uv != nullptr, normal != nullptr);
    }
    out += '\n';
  }
  const auto bytes = std::as_bytes(std::span(out));
  return {bytes.begin(), bytes.end()};
}

}  // namespace deltamesh
