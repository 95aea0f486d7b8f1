// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/losses.h"

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

nlohmann::ordered_json left_out_array(const LossReport& report) {
  auto array = nlohmann::ordered_json::array();
  for (const LeftOut& entry : report.left_out)
    array.push_back({{"kind", word_of(entry.kind)}, {"name", entry.name}, {"count", entry.count}});
  return array;
}

}  // namespace deltamesh::cli
