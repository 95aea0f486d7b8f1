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
#include "connectivity/seams/seams.h"
#include "support/soups.h"

namespace {

using namespace deltamesh;

test::Soup choose_mesh(unsigned choice) {
  switch (choice % 4) {
    case 0:
      return test::grid(6, 5, true, false, 4, 1);
    case 1:
      return test::fan(30, true);
    case 2:
      return test::random_soup(2, 8, 20);
    default:
      return {"one_face_and_lone_vertices", {0, 1, 2}, 6};
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const test::Soup soup = choose_mesh(data[size - 2]);
  const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
  const std::uint32_t vertex_count = soup.vertex_count + data[size - 1];
  Payload payload(std::as_bytes(std::span(data, size - 2)));
  payload.is_compact = data[size - 2] >= 0x80;
  const auto split = read_seams(payload, coded.triangles, soup.vertex_count, vertex_count);
  if (!split) {
    if (split.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
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
  for (const Payload& form : {Payload(again.payload), Payload::compact(again.compact)}) {
    const auto copy = read_seams(form, coded.triangles, soup.vertex_count, vertex_count);
    if (!copy || copy->triangles != split->triangles || copy->geometric != split->geometric) std::abort();
  }
  return 0;
}
