// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The corpus' meshes, as parameters of tests. The corpus is no part of the project: DELTAMESH_CORPUS names
// its folder.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh::testing_corpus {

namespace fs = std::filesystem;

inline constexpr const char* kNoCorpus = "";

inline fs::path corpus() {
  const char* named = std::getenv("DELTAMESH_CORPUS");
  return named != nullptr ? named : DELTAMESH_DEFAULT_CORPUS;
}

/// Paths relative to the corpus, sorted; one empty path where there is none.
inline std::vector<std::string> mesh_files() {
  std::vector<std::string> files;
  for (const char* folder : {"paper", "models", "robot", "formats", "gltf"}) {
    std::error_code absent;
    for (const auto& entry : fs::recursive_directory_iterator(corpus() / folder, absent))
      if (entry.is_regular_file() && format_of_path(entry.path().string()))
        files.push_back(fs::relative(entry.path(), corpus()).string());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) files.emplace_back(kNoCorpus);
  return files;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.empty() ? "none" : info.param;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

}  // namespace deltamesh::testing_corpus
