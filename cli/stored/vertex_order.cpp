// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stored/vertex_order.h"

#include <algorithm>
#include <limits>

#include "deltamesh/files.h"
#include "exit_codes.h"
#include "report/console.h"

namespace deltamesh::cli {

std::vector<std::byte> order_bytes(std::span<const std::uint32_t> order,
                                   std::span<const std::uint32_t> file_vertices) {
  std::vector<std::byte> bytes;
  bytes.reserve(4 * order.size());
  for (const std::uint32_t vertex : order) {
    const std::uint32_t number = file_vertices.empty() ? vertex : file_vertices[vertex];
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<std::byte>((number >> shift) & 0xff));
  }
  return bytes;
}

std::vector<std::uint32_t> load_order(const std::string& path, std::span<const std::uint32_t> file_vertices,
                                      int& status) {
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) {
    status = fail(path, bytes.error());
    return {};
  }
  if (bytes->empty() || bytes->size() % 4 != 0) {
    print_error(path, "not an order file: its size must be a multiple of four bytes and not zero");
    status = kBadInput;
    return {};
  }
  std::vector<std::uint32_t> order(bytes->size() / 4);
  for (std::size_t i = 0; i < bytes->size(); ++i)
    order[i / 4] |= std::to_integer<std::uint32_t>((*bytes)[i]) << (8 * (i % 4));
  if (file_vertices.empty()) return order;
  for (std::uint32_t& number : order) {
    const auto found = std::ranges::lower_bound(file_vertices, number);
    number = found != file_vertices.end() && *found == number
                 ? static_cast<std::uint32_t>(found - file_vertices.begin())
                 : std::numeric_limits<std::uint32_t>::max();
  }
  return order;
}

}  // namespace deltamesh::cli
