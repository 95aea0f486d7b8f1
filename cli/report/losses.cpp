// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/losses.h"

#include <algorithm>
#include <vector>

#include "report/console.h"

namespace deltamesh::cli {

std::string left_out_text(const LossReport& report) {
  std::string text;
  for (const LeftOut& entry : report.left_out) (text += text.empty() ? "" : ", ") += describe(entry);
  return text;
}

void print_left_out(const LossReport& report, std::ostream& out) {
  if (!report.left_out.empty()) out << "  left out  " << left_out_text(report) << '\n';
}

void print_rounding(double most, std::ostream& out) {
  if (most > 0)
    out << "  rounding  coordinates became float32, off by up to " << brief(most)
        << ", which adds to the max error\n";
}

void print_stretch(double uv_scale, std::ostream& out) {
  if (uv_scale > 1)
    out << "  textures  stretched " << brief(uv_scale)
        << " times by KHR_texture_transform, for which the bound is divided\n";
}

std::uint64_t count_unreferenced(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.vertex_count());
  for (const std::uint32_t v : mesh.triangles) is_used[v] = true;
  return static_cast<std::uint64_t>(std::ranges::count(is_used, false));
}

std::string unreferenced_text(std::uint64_t count, const char* fate) {
  return counted(count, "vertex that no face uses was ", "vertices that no face uses were ") + fate;
}

void print_dropped(std::uint64_t unreferenced, std::ostream& out) {
  if (unreferenced > 0) out << "  unused    " << unreferenced_text(unreferenced, "dropped") << '\n';
}

nlohmann::ordered_json left_out_array(const LossReport& report) {
  auto array = nlohmann::ordered_json::array();
  for (const LeftOut& entry : report.left_out)
    array.push_back({{"kind", word_of(entry.kind)}, {"name", entry.name}, {"count", entry.count}});
  return array;
}

}  // namespace deltamesh::cli
