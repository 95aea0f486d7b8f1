// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Committed streams that break one rule each are refused with the tag of that rule. They are kept by
// tests/spec/make_invalid_streams.py, and the reference decoder refuses them with the same tags.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>

#include "deltamesh/decode.h"
#include "deltamesh/io.h"

namespace deltamesh {
namespace {

TEST(InvalidStreams, AreRefusedWithTheTagOfTheRuleThatTheyBreak) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DELTAMESH_GOLDEN_DIR "/invalid")) {
    SCOPED_TRACE(entry.path().filename().string());
    const auto bytes = read_file(entry.path().string());
    ASSERT_TRUE(bytes) << describe(bytes.error());
    const auto decoded = decode(*bytes);
    ASSERT_FALSE(decoded);
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(decoded.error().rule, name.substr(0, name.find('.'))) << describe(decoded.error());
    ++count;
  }
  EXPECT_GE(count, 160U);
}

}  // namespace
}  // namespace deltamesh
