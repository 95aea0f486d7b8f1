// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes into the importer of STL files.
#include "import_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  deltamesh::fuzz_import(data, size, deltamesh::FileFormat::kStl);
  return 0;
}
