// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/byte_reader.h"
#include "base/checked.h"
#include "base/large_vector.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "connectivity/border.h"
#include "connectivity/compact_connectivity.h"
#include "connectivity/gluing.h"
#include "connectivity/op_coder.h"
#include "connectivity/refusal.h"
#include "connectivity/traversal.h"
#include "connectivity/zipper.h"
#include "entropy/compact_reader.h"

namespace deltamesh {
namespace {

/// Takes every op from the compact coder.
class CompactGuide {
 public:
  explicit CompactGuide(CompactReader& reader) : reader_(reader), ops_(reader) {}

  void start(const Border& border) { starts_.push_back(border.vertex_count()); }
  /// As PayloadGuide's.
  std::span<const std::uint32_t> starts() const noexcept { return starts_; }

  [[gnu::always_inline]] BorderStep next(const Border& border, const Gate& gate) {
    return ops_.code({}, border, gate);
  }
  [[gnu::always_inline]] auto run(const Gate& gate) { return ops_.run(gate); }
  void begin(const OpCoder<CompactReader>::Run& run) { ops_.begin(run); }
  bool failed() const noexcept { return reader_.failed(); }

 private:
  CompactReader& reader_;
  std::vector<std::uint32_t> starts_;
  OpCoder<CompactReader> ops_;
};

/// Faces and vertices that room is made for at once: untouched memory, so a little for nothing. Where the
/// bytes hold more the room grows.
std::size_t reserved_at_once(std::uint32_t declared, std::size_t bytes) noexcept {
  constexpr std::size_t kPerByte = 32;
  constexpr std::size_t kAnyway = std::size_t{1} << 22;
  return std::min<std::size_t>(declared, std::max(kAnyway, bytes * kPerByte));
}

Result<void> check_face_count(std::uint32_t faces, std::size_t bytes) {
  if (faces <= saturating_mul(bytes, kFacesPerCompactByte)) return {};
  return Refusal{"more faces than the ops can hold", "CONN-2"}.error();
}

/// First manifold vertex of every component, from a walk that fills the border.
Result<std::vector<std::uint32_t>> read_walk(CompactReader& reader, Border& border) {
  CompactGuide guide(reader);
  if (traverse(border, guide)) return std::vector(guide.starts().begin(), guide.starts().end());
  if (reader.failed()) DELTAMESH_CHECK(reader.finish(kTagConnectivity));
  return refusal_of(border).error();
}

Result<Connectivity> read_whole(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                std::uint32_t triangle_count) {
  DELTAMESH_CHECK(check_face_count(triangle_count, bytes.size()));
  CompactReader reader(bytes);
  Border border(triangle_count);
  border.reserve(reserved_at_once(vertex_count, bytes.size()),
                 reserved_at_once(triangle_count, bytes.size()));
  DELTAMESH_TRY(const auto starts, read_walk(reader, border));
  DELTAMESH_TRY(const auto vertex,
                read_compact_gluing(reader, {}, border.faces(), border.vertex_count(), vertex_count));
  DELTAMESH_CHECK(reader.finish(kTagConnectivity));
  Connectivity read{.triangles = border.take_faces(),
                    .open_edges = border.open_edges(),
                    .runs = connected_runs(starts, vertex, border.vertex_count())};
  renumber(read.triangles, vertex);
  renumber(read.open_edges, vertex);
  return read;
}

/// Whether manifold vertices below `end` are vertices of the same numbers. `vertex`: of each, or nothing.
bool are_their_own(std::span<const std::uint32_t> vertex, std::uint32_t end) noexcept {
  std::uint32_t others = 0;
  for (std::uint32_t m = 0; m < end && m < vertex.size(); ++m) others += vertex[m] != m ? 1 : 0;
  return others == 0;
}

/// What there is of each half [CONN-15].
struct Halves {
  std::array<std::span<const std::byte>, 2> bytes;
  std::array<std::uint32_t, 2> faces;
  std::uint32_t first_vertices;  ///< manifold vertices of the first half
};

Result<Halves> split_payload(std::span<const std::byte> bytes, std::uint32_t triangle_count) {
  ByteReader in(bytes, kTagConnectivity);
  DELTAMESH_TRY(const std::uint64_t first_size, in.read<std::uint64_t>());
  DELTAMESH_TRY(const std::uint32_t first_vertices, in.read<std::uint32_t>());
  DELTAMESH_TRY(const auto first_bytes, in.read_bytes(first_size));
  const std::uint32_t first_faces = first_half_of(triangle_count);
  const Halves halves{.bytes = {first_bytes, bytes.subspan(in.position())},
                      .faces = {first_faces, triangle_count - first_faces},
                      .first_vertices = first_vertices};
  for (std::size_t half = 0; half < 2; ++half)
    DELTAMESH_CHECK(check_face_count(halves.faces[half], halves.bytes[half].size()));
  if (first_vertices > std::uint64_t{3} * first_faces)
    return Refusal{"more manifold vertices than the first half can have", "CONN-15"}.error();
  return halves;
}

Result<Connectivity> read_halves(std::span<const std::byte> payload, std::uint32_t vertex_count,
                                 std::uint32_t triangle_count) {
  DELTAMESH_TRY(const auto halves, split_payload(payload, triangle_count));
  const auto& bytes = halves.bytes;
  const auto& faces = halves.faces;
  const std::uint32_t first_vertices = halves.first_vertices;
  // Of one walk each, so far apart that threads do not wait for each other's memory.
  struct alignas(64) Walk {
    CompactReader reader;
    std::optional<Border> border;
    Result<std::vector<std::uint32_t>> starts;
  };
  std::array<Walk, 2> walks = {Walk{CompactReader(bytes[0]), {}, std::vector<std::uint32_t>()},
                               Walk{CompactReader(bytes[1]), {}, std::vector<std::uint32_t>()}};
  const bool is_alone = ThreadTeam::current() == nullptr;  // so that the first half comes first
  share_work(2, [&](std::uint32_t half) {
    Walk& walk = walks[half];
    if (half == 0) {
      walk.border.emplace(faces[0]);
      walk.border->reserve(reserved_at_once(first_vertices, bytes[0].size()),
                           reserved_at_once(triangle_count, payload.size()));  // for both
    } else if (is_alone) {
      walk.border.emplace(faces[1], first_vertices, walks[0].border->take_faces());
      walk.border->reserve(reserved_at_once(vertex_count / 2, bytes[1].size()), 0);
    } else {
      walk.border.emplace(faces[1], first_vertices);
      walk.border->reserve(reserved_at_once(vertex_count / 2, bytes[1].size()),
                           reserved_at_once(faces[1], bytes[1].size()));
    }
    walk.starts = read_walk(walk.reader, *walk.border);
  });
  DELTAMESH_TRY(std::vector<std::uint32_t> starts, std::move(walks[0].starts));
  DELTAMESH_TRY(const std::vector<std::uint32_t> more_starts, std::move(walks[1].starts));
  starts.insert(starts.end(), more_starts.begin(), more_starts.end());
  Border& first = *walks[0].border;
  Border& second = *walks[1].border;
  CompactReader& reader = walks[1].reader;
  DELTAMESH_CHECK(walks[0].reader.finish(kTagConnectivity));
  if (first.vertex_count() != first_vertices)
    return Refusal{"the first half has another number of manifold vertices", "CONN-15"}.error();

  DELTAMESH_TRY(const auto zipped, read_zips(reader, first, second));
  std::vector<std::uint32_t> triangles = is_alone ? second.take_faces() : first.take_faces();
  if (!is_alone) {
    const std::vector<std::uint32_t> others = second.take_faces();
    triangles.insert(triangles.end(), others.begin(), others.end());
  }
  const std::uint32_t manifold_count = second.vertex_count();
  DELTAMESH_TRY(const auto vertex,
                read_compact_gluing(reader, zipped.vertices, triangles, manifold_count, vertex_count));
  DELTAMESH_CHECK(reader.finish(kTagConnectivity));
  DELTAMESH_CHECK(check_zipped(zipped, vertex));

  Connectivity read{.triangles = std::move(triangles),
                    .open_edges = first.open_edges(),
                    .runs = connected_runs(starts, vertex, manifold_count)};
  const LargeVector<DirectedEdge> others = second.open_edges();
  read.open_edges.insert(read.open_edges.end(), others.begin(), others.end());
  renumber(std::span(read.triangles)
               .subspan(are_their_own(vertex, first_vertices) ? std::size_t{3} * faces[0] : 0),
           vertex);
  renumber(read.open_edges, vertex);
  return read;
}

}  // namespace

Result<Connectivity> read_compact_connectivity(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                               std::uint32_t triangle_count, Halving halving) {
  const auto read = is_halved(triangle_count, halving) ? read_halves : read_whole;
  return read(bytes, vertex_count, triangle_count);
}

}  // namespace deltamesh
