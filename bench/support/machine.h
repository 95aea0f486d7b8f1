// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a table of measurements has to say about where it was made.
#pragma once

#include <string>

namespace deltamesh::bench {

/// From the build: written anew whenever the program is built.
struct BuildInfo {
  const char* commit;    ///< git describe, or "unknown"
  const char* compiler;  ///< name and version
  const char* flags;     ///< of the build type and the caller's
};
extern const BuildInfo kBuildInfo;

/// Model name of the processor, "unknown" where the system does not tell.
std::string processor_name();

}  // namespace deltamesh::bench
