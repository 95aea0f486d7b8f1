// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether two decodes came to the same.
#pragma once

#include <gtest/gtest.h>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::test {

inline void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.face_groups, b.face_groups);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    EXPECT_EQ(a.attributes[i].name, b.attributes[i].name);
    EXPECT_EQ(a.attributes[i].values, b.attributes[i].values);
  }
}

inline void expect_same(const Result<Mesh>& a, const Result<Mesh>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a) {
    expect_same(*a, *b);
  } else {
    EXPECT_EQ(a.error().code, b.error().code);
    EXPECT_STREQ(a.error().message, b.error().message);
  }
}

}  // namespace deltamesh::test
