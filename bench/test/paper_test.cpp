// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "paper/rows.h"
#include "paper/study.h"
#include "support/corpus.h"

namespace deltamesh::bench {
namespace {

std::string corpus() {
  return std::getenv("DELTAMESH_CORPUS") != nullptr ? default_corpus()
                                                    : DELTAMESH_SOURCE_DIR "/../shared/corpus";
}

TEST(PaperTable, FollowsThePaper) {
  if (!std::filesystem::is_directory(corpus())) GTEST_SKIP() << "skipped: no corpus";
  for (const PaperRow& row : kPaperRows) {
    SCOPED_TRACE(std::string(row.model) + ", " + std::to_string(row.bits) + " bits, " +
                 std::to_string(row.anchors) + " anchors");
    const auto mesh = load_welded(corpus() + "/paper/" + row.model + ".ply");
    ASSERT_TRUE(mesh) << describe(mesh.error());
    const auto point = PaperStudy(*mesh).code(row.bits, row.anchors);
    ASSERT_TRUE(point) << describe(point.error());
    EXPECT_GT(point->vde_over_step, 0.36);
    EXPECT_LT(point->vde_over_step, 0.41);
    if (row.paper_ratio > 0) {
      EXPECT_NEAR(point->lfe / point->vde / row.paper_ratio, 1, 0.2);
    }
  }
}

}  // namespace
}  // namespace deltamesh::bench
