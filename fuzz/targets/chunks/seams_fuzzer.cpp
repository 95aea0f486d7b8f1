// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// SEAM payloads from anywhere, over a small mesh. The last two bytes choose the mesh and the form, and the
// number of copies beyond the first. What is read must come back unchanged from both forms.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "connectivity/faces/faces.h"
#include "connectivity/plain/topology.h"
#include "connectivity/seams/seams.h"
#include "goal.h"
#include "meshes.h"

namespace {

using namespace deltamesh;

fuzz::Goal plain_seams("the plain form");
fuzz::Goal compact_seams("the compact form");

void check_plain(std::span<const std::byte> payload, std::uint32_t geometric_count,
                 std::uint32_t vertex_count) {
  const auto geometric = read_plain_seams(payload, geometric_count, vertex_count);
  if (!geometric) return;
  const auto again = read_plain_seams(write_plain_seams(*geometric), geometric_count, vertex_count);
  if (!again || *again != *geometric) std::abort();
  plain_seams.reach();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const test::Soup soup = fuzz::choose_soup(data[size - 2]);
  const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
  const std::uint32_t vertex_count = soup.vertex_count + data[size - 1];
  const auto payload = std::as_bytes(std::span(data, size - 2));
  if (data[size - 2] < 0x80) {
    check_plain(payload, soup.vertex_count, vertex_count);
    return 0;
  }
  const auto split = read_seams(payload, coded.triangles, soup.vertex_count, vertex_count);
  if (!fuzz::check(split)) return 0;
  if (split->geometric.size() != vertex_count || split->triangles.size() != coded.triangles.size())
    std::abort();
  std::vector<std::uint8_t> used(vertex_count, 0);
  for (std::size_t c = 0; c < split->triangles.size(); ++c) {
    const std::uint32_t v = split->triangles[c];
    if (v >= vertex_count || split->geometric[v] != coded.triangles[c]) std::abort();
    used[v] = 1;
  }
  std::vector<std::uint32_t> lone;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (used[v] == 0) lone.push_back(v);
  }
  const CodedSeams again = write_seams(coded.triangles, soup.vertex_count, split->triangles, lone);
  const auto copy = read_seams(again.payload, coded.triangles, soup.vertex_count, vertex_count);
  if (!copy || copy->triangles != split->triangles || copy->geometric != split->geometric) std::abort();
  compact_seams.reach();
  return 0;
}
