// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Output files.
#pragma once

#include <string>

namespace deltamesh::bench {

/// Writes `folder`/`name`; makes the folder where absent. False, and a line on stderr, where it cannot.
bool write_text(const std::string& folder, const std::string& name, const std::string& text);

}  // namespace deltamesh::bench
