// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_reader.h"
#include "base/try.h"
#include "connectivity/plain_forms.h"
#include "connectivity/seams/coder.h"
#include "connectivity/seams/corner_copies.h"
#include "connectivity/seams/seams.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// No seams: vertices are the geometric vertices.
SplitVertices unsplit(std::span<const std::uint32_t> geometric_triangles, std::uint32_t geometric_count) {
  SplitVertices split;
  split.triangles.assign(geometric_triangles.begin(), geometric_triangles.end());
  split.geometric.resize(geometric_count);
  for (std::uint32_t g = 0; g < geometric_count; ++g) split.geometric[g] = g;
  return split;
}

/// Errors: kTruncated, kInvalidStream [SEAM-6 .. 8, CMP-3].
Result<CornerCopies> read_compact(const ByteReader& in, std::span<const std::byte> bytes,
                                  std::span<const std::uint32_t> geometric_triangles,
                                  std::uint32_t geometric_count, std::uint32_t extra_copies) {
  if (extra_copies > geometric_triangles.size()) return in.invalid("more copies than corners", "SEAM-6");
  CompactReader reader(bytes);
  SeamCoder<CompactReader> coder(reader, geometric_count, extra_copies);
  CornerCopies copies{std::vector<std::uint32_t>(geometric_count, 1),
                      std::vector<std::uint32_t>(geometric_triangles.size(), 0)};
  const char* const broken = coder.code(geometric_triangles, copies);
  if (reader.failed() || broken == nullptr) DELTAMESH_CHECK(reader.finish(kTagSeams));
  if (broken != nullptr) return in.invalid("copies do not fit the vertices and corners", broken);
  return copies;
}

}  // namespace

Result<SplitVertices> read_seams(Payload payload, std::span<const std::uint32_t> geometric_triangles,
                                 std::uint32_t geometric_count, std::uint32_t vertex_count) {
  ByteReader in(payload.bytes, kTagSeams);
  if (vertex_count < geometric_count || payload.bytes.empty() != (vertex_count == geometric_count))
    return in.invalid("seams do not fit the vertex counts", "SEAM-1");
  if (payload.bytes.empty()) return unsplit(geometric_triangles, geometric_count);
  const std::uint32_t extra_copies = vertex_count - geometric_count;
  DELTAMESH_TRY(const CornerCopies copies,
                payload.is_compact
                    ? read_compact(in, payload.bytes, geometric_triangles, geometric_count, extra_copies)
                    : read_plain_copies(payload.bytes, geometric_triangles, geometric_count, extra_copies));
  return split_vertices(geometric_triangles, copies);
}

}  // namespace deltamesh
