// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole files. Library target deltamesh::files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh {

/// Errors: kFileOpen, kFileRead, kOutOfMemory.
Result<std::vector<std::byte>> read_file(const std::string& path) noexcept;

/// Whole or not at all: to a temporary file beside it, then a rename. Devices and pipes are written in place,
/// links stay, and what they point to is replaced or made. Errors: kFileWrite, kOutOfMemory.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) noexcept;

struct NewFile {
  std::string path;
  std::span<const std::byte> bytes;
};

/// Files that belong together, all or none: each as by write_file(), none renamed before the temporaries of
/// all are written, so that only a rename that fails after another can part them. Devices and pipes, which
/// cannot be undone, come first. Errors: the same, also for two files with one target; `where`: number of the
/// file at fault, which describe() does not show.
Result<void> write_files(std::span<const NewFile> files) noexcept;

}  // namespace deltamesh
