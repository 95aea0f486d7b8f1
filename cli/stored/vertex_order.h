// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Files of `encode --order-out`: the number in the mesh file of every decoded vertex, little-endian uint32.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace deltamesh::cli {

/// `order`: vertices of the mesh that was read; `file_vertices`: of Imported.
std::vector<std::byte> order_bytes(std::span<const std::uint32_t> order,
                                   std::span<const std::uint32_t> file_vertices);

/// Reads such a file. A dropped vertex becomes an index that is out of range in any mesh. Empty, with
/// `status` set, where the file is bad.
std::vector<std::uint32_t> load_order(const std::string& path, std::span<const std::uint32_t> file_vertices,
                                      int& status);

}  // namespace deltamesh::cli
