// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Prints our figures beside those of the paper's Table 2, as a Markdown table.
#include <cstdio>
#include <string>
#include <string_view>

#include "paper/paper_rows.h"

namespace {

using namespace deltamesh;

bool print_row(const bench::WeldedMesh& mesh, const bench::PaperRow& row) {
  const auto figures = bench::measure_paper_row(mesh, row);
  if (!figures) {
    std::fprintf(stderr, "%s: %s\n", row.model, describe(figures.error()).c_str());
    return false;
  }
  std::printf("| %s | %d | %u | %.3f | %.2f ", row.model, row.bits, row.anchors, figures->vde_over_step,
              figures->ratio);
  if (row.paper_ratio > 0) {
    std::printf("| %.1f | %.2f |\n", row.paper_ratio, figures->ratio / row.paper_ratio);
  } else {
    std::printf("| | |\n");
  }
  return true;
}

bool print_table(const std::string& corpus) {
  std::printf(
      "| model | bits | anchors | S_q rms / (range 2^-p) | M_q/S_q | M_q/S_q paper | ours / paper |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  std::string_view loaded;
  bench::WeldedMesh mesh;
  for (const bench::PaperRow& row : bench::paper_rows()) {
    if (loaded != row.model) {
      auto read = bench::load_welded(corpus + "/paper/" + row.model + ".ply");
      if (!read) {
        std::fprintf(stderr, "%s: %s\n", row.model, describe(read.error()).c_str());
        return false;
      }
      mesh = *std::move(read);
      loaded = row.model;
    }
    if (!print_row(mesh, row)) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 || std::string_view(argv[1]) != "--corpus") {
    std::fprintf(stderr, "usage: deltamesh_paper_table --corpus DIR\n");
    return 2;
  }
  return print_table(argv[2]) ? 0 : 1;
}
