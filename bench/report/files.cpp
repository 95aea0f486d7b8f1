// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/files.h"

#include <cstdio>
#include <filesystem>
#include <span>

#include "deltamesh/io.h"

namespace deltamesh::bench {

bool write_text(const std::string& folder, const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  const auto written = write_file(path.string(), std::as_bytes(std::span(text)));
  if (!written) std::fprintf(stderr, "%s: %s\n", path.c_str(), describe(written.error()).c_str());
  return written.has_value();
}

}  // namespace deltamesh::bench
