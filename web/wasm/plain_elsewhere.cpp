// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Frames of zstd's and plain forms for `core`: the module `plain` reads them.
#include "attributes/plain/plain.h"
#include "base/try.h"
#include "connectivity/plain_forms.h"
#include "entropy/zstd_frame.h"
#include "parts.h"

namespace deltamesh {
namespace {

using web::PlainCall;
using web::PlainForm;

Result<web::PartArrays> read(PlainCall call, std::span<const std::byte> bytes) {
  call.bytes = web::hand_over(web::Part::kPlain, bytes);
  return web::call_part(web::Part::kPlain, call);
}

/// Of what was returned, the arrays in order.
template <class... Vectors>
void take_all(const web::PartArrays& returned, Vectors&... to) {
  std::size_t next = 0;
  (web::take_array(web::Part::kPlain, returned.arrays[next++], to), ...);
}

}  // namespace

bool expand_frame(std::span<const std::byte> frame, std::span<std::byte> expanded) noexcept {
  const auto returned =
      read({.form = PlainForm::kFrame, .counts = {static_cast<std::uint32_t>(expanded.size())}}, frame);
  if (!returned || returned->count == 0) return false;
  take(web::Part::kPlain, expanded.data(), returned->arrays[0].address, expanded.size());
  return true;
}

Result<ManifoldFaces> read_plain_faces(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                       std::uint32_t triangle_count) {
  DELTAMESH_TRY(const auto returned,
                read({.form = PlainForm::kFaces, .counts = {vertex_count, triangle_count}}, bytes));
  ManifoldFaces faces;
  take_all(returned, faces.triangles, faces.open_edges, faces.starts, faces.vertex);
  return faces;
}

Result<CornerCopies> read_plain_copies(std::span<const std::byte> bytes,
                                       std::span<const std::uint32_t> geometric_triangles,
                                       std::uint32_t geometric_count, std::uint32_t extra_copies) {
  DELTAMESH_TRY(const auto returned,
                read({.form = PlainForm::kCopies,
                      .counts = {geometric_count, extra_copies},
                      .triangles = web::hand_over(web::Part::kPlain, geometric_triangles)},
                     bytes));
  CornerCopies copies;
  take_all(returned, copies.of_vertex, copies.of_corner);
  return copies;
}

Result<std::vector<std::uint32_t>> read_plain_groups(std::span<const std::byte> bytes,
                                                     std::uint32_t triangle_count) {
  DELTAMESH_TRY(const auto returned, read({.form = PlainForm::kGroups, .counts = {triangle_count}}, bytes));
  std::vector<std::uint32_t> groups;
  take_all(returned, groups);
  return groups;
}

Result<MeshOrder> read_plain_order(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                   std::uint32_t triangle_count) {
  DELTAMESH_TRY(const auto returned,
                read({.form = PlainForm::kOrder, .counts = {vertex_count, triangle_count}}, bytes));
  MeshOrder order;
  take_all(returned, order.vertices, order.faces, order.rotation);
  return order;
}

Result<std::vector<std::byte>> read_plain_values(std::span<const std::byte> payload, const Attribute& shape,
                                                 std::uint32_t rows) {
  DELTAMESH_TRY(const auto returned, read({.form = PlainForm::kValues,
                                           .counts = {rows},
                                           .kind = shape.kind,
                                           .type = shape.type,
                                           .components = shape.components},
                                          payload));
  std::vector<std::byte> values;
  take_all(returned, values);
  return values;
}

}  // namespace deltamesh
