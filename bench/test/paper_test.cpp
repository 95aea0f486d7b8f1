// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "paper/paper_rows.h"

namespace deltamesh::bench {
namespace {

std::filesystem::path corpus() {
  const char* given = std::getenv("DELTAMESH_CORPUS");
  return given != nullptr ? given : DELTAMESH_SOURCE_DIR "/../shared/corpus";
}

TEST(PaperTable, FollowsThePaper) {
  if (!std::filesystem::is_directory(corpus())) GTEST_SKIP() << "skipped: no corpus";
  for (const PaperRow& row : paper_rows()) {
    SCOPED_TRACE(std::string(row.model) + ", " + std::to_string(row.bits) + " bits, " +
                 std::to_string(row.anchors) + " anchors");
    const auto mesh = load_welded((corpus() / "paper" / row.model).string() + ".ply");
    ASSERT_TRUE(mesh) << describe(mesh.error());
    const auto figures = measure_paper_row(*mesh, row);
    ASSERT_TRUE(figures) << describe(figures.error());
    EXPECT_GT(figures->vde_over_step, 0.36);
    EXPECT_LT(figures->vde_over_step, 0.41);
    if (row.paper_ratio > 0) {
      EXPECT_NEAR(figures->ratio / row.paper_ratio, 1, 0.2);
    }
  }
}

}  // namespace
}  // namespace deltamesh::bench
