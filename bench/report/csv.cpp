// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/csv.h"

#include "report/text.h"

namespace deltamesh::bench {
namespace {

constexpr int kDigits = 9;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  result += '"';
  return result;
}

}  // namespace

std::string render_csv(const Run& run) {
  std::string csv =
      "mesh,vertices,triangles,diagonal,peer,setting,bytes,bits_per_vertex,vde_rms,lfe_rms,max_error,"
      "vde_percent,lfe_percent,max_percent,encode_seconds,decode_seconds\r\n";
  for (const Measurement& m : run.measurements) {
    csv += join({quoted(m.mesh), ",", std::to_string(m.vertices), ",", std::to_string(m.triangles), ",",
                 significant(m.diagonal, kDigits), ",", quoted(m.peer), ",", quoted(m.setting), ",",
                 std::to_string(m.bytes)});
    const double figures[] = {m.bits_per_vertex(),
                              m.quality.vde_rms,
                              m.quality.lfe_rms,
                              m.quality.max_error,
                              m.percent(m.quality.vde_rms),
                              m.percent(m.quality.lfe_rms),
                              m.percent(m.quality.max_error),
                              m.encode_seconds,
                              m.decode_seconds};
    for (const double figure : figures) csv += join({",", significant(figure, kDigits)});
    csv += "\r\n";
  }
  return csv;
}

}  // namespace deltamesh::bench
