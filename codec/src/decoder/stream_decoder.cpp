// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "decoder/stream_decoder.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "attributes/attribute.h"
#include "base/memory/large_vector.h"
#include "base/small_code.h"
#include "base/threads/task.h"
#include "base/threads/thread_team.h"
#include "base/try.h"
#include "connectivity/faces/faces.h"
#include "connectivity/groups/groups.h"
#include "connectivity/groups/names.h"
#include "connectivity/plain/topology.h"
#include "connectivity/seams/seams.h"
#include "decoder/read_grid_chunks.h"
#include "decoder/restore_order.h"
#include "deltamesh/model_states.h"
#include "entropy/expand_chunk.h"
#include "format/chunk/kinds.h"
#include "format/vertex_positions.h"
#include "highpass/highpass.h"
#include "positions/plain.h"
#include "positions/positions.h"
#include "states/stream_models.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

constexpr double kGeometryDone = 0.85;

void report_progress(const DecodeOptions& options, double share) {
  if (options.progress) options.progress(share);
}

Error limit_exceeded(const char* message) noexcept {
  return {.code = ErrorCode::kLimitExceeded, .message = message};
}

/// Errors: kLimitExceeded.
Result<void> check_limits(const FileHeader& header, const DecodeLimits& limits) noexcept {
  if (header.vertices > limits.vertices) return limit_exceeded("more vertices than the caller's limit");
  if (header.triangles > limits.triangles) return limit_exceeded("more triangles than the caller's limit");
  if (header.attributes.size() > limits.attributes)
    return limit_exceeded("more attributes than the caller's limit");
  return {};
}

class StreamDecoder {
 public:
  StreamDecoder(const Container& container, const DecodeOptions& options, ThreadTeam* team,
                StreamModels* learnt)
      : container_(container),
        header_(container.header()),
        options_(options),
        team_(team),
        start_(options.starting_states != nullptr ? &options.starting_states->models() : nullptr),
        learnt_(learnt),
        is_of_grid_(is_of_grid(container.header())) {
    if (learnt != nullptr) learnt->colors.resize(header_.attributes.size());
  }

  Result<Mesh> run() {
    Mesh mesh;
    mesh.origin = header_.origin;
    DELTAMESH_CHECK(check_form());
    DELTAMESH_CHECK(is_plain_ ? read_plain(mesh.triangles) : read_faces(mesh.triangles));
    DELTAMESH_TRY(mesh.face_groups, read_groups(mesh.triangles));
    if constexpr (!kSmallCode) {  // no module hands them out
      DELTAMESH_TRY(mesh.group_names, read_names());
    }
    if (header_.geometry != kGeometryPredictive) build_graphs(mesh.triangles);
    if (header_.geometry == kGeometryPredictive) {
      DELTAMESH_TRY(mesh.positions, read_geometry(mesh.triangles));
      report_progress(options_, kGeometryDone);
      DELTAMESH_TRY(mesh.attributes, read_attributes(mesh.triangles, mesh.positions));
    } else {
      // Nothing that is parsed may depend on solved positions [ATTR-10], so both can go on at a time.
      Task attributes(team_, [&] { return read_attributes(mesh.triangles, {}); });
      DELTAMESH_TRY(mesh.positions, read_geometry(mesh.triangles));
      report_progress(options_, kGeometryDone);
      DELTAMESH_TRY(mesh.attributes, attributes.get());
    }
    if (header_.keeps_order && !is_plain_) {
      DELTAMESH_TRY(const auto chunk, expand_single(container_, kTagOrder));
      DELTAMESH_TRY(const auto order, read_order(chunk.bytes(), mesh.triangles, header_.vertices));
      mesh = restore_order(mesh, order);
    }
    report_progress(options_, 1);
    return mesh;
  }

 private:
  /// Sets is_plain_. Errors: kInvalidStream [PLN-1].
  Result<void> check_form() {
    bool is_compact = false;
    for (const ChunkEntry& entry : container_.entries()) {
      is_compact |= entry.codec == ChunkCodec::kCompact;
      const bool has_form = entry.tag != kTagAttribute && kind_of(entry.tag) != kLetters;
      is_plain_ |= entry.codec != ChunkCodec::kCompact && has_form;
    }
    if (is_of_grid_ && !is_compact)
      return Error{.code = ErrorCode::kInvalidStream, .message = "a grid in the plain form", .rule = "PLN-1"};
    if (!is_plain_ || !is_compact) {
      is_plain_ = !is_compact;
      return {};
    }
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "chunks of the plain form beside those of the compact form",
                 .rule = "PLN-1"};
  }

  /// The same as read_faces().
  Result<void> read_plain(std::vector<std::uint32_t>& triangles) {
    DELTAMESH_TRY(const auto connectivity, expand_single(container_, kTagConnectivity));
    DELTAMESH_TRY(triangles, read_plain_faces(connectivity.bytes(), header_.triangles, header_.vertices));
    DELTAMESH_TRY(const auto seams, expand_single(container_, kTagSeams));
    DELTAMESH_TRY(copies_, read_plain_seams(seams.bytes(), header_.geometric_vertices, header_.vertices));
    if (is_split()) {
      geometric_triangles_.reserve(triangles.size());
      for (const std::uint32_t v : triangles) geometric_triangles_.push_back(copies_[v]);
    }
    return check_components(count_components(geometric(triangles), header_.geometric_vertices));
  }

  /// Faces over the mesh's vertices; where seams split some, those over the geometric vertices as well.
  Result<void> read_faces(std::vector<std::uint32_t>& triangles) {
    DELTAMESH_CHECK(is_of_grid_ ? read_faces_of_grid(triangles) : read_faces_of_connectivity(triangles));
    DELTAMESH_TRY(const auto seams, expand_single(container_, kTagSeams));
    if (seams.bytes().empty() && header_.vertices == header_.geometric_vertices) return {};
    DELTAMESH_TRY(auto split,
                  read_seams(seams.bytes(), triangles, header_.geometric_vertices, header_.vertices));
    geometric_triangles_ = std::exchange(triangles, std::move(split.triangles));
    copies_ = std::move(split.geometric);
    return {};
  }

  /// With the positions, which wait.
  Result<void> read_faces_of_grid(std::vector<std::uint32_t>& triangles) {
    DELTAMESH_TRY(auto mesh, read_grid_chunks(container_, of_grid()));
    triangles = std::move(mesh.triangles);
    grid_positions_ = std::move(mesh.positions);
    return {};
  }

  Result<void> read_faces_of_connectivity(std::vector<std::uint32_t>& triangles) {
    DELTAMESH_TRY(const auto connectivity, expand_single(container_, kTagConnectivity));
    DELTAMESH_TRY(auto read, read_connectivity(connectivity.bytes(), header_.geometric_vertices,
                                               header_.triangles, of_ops()));
    DELTAMESH_CHECK(check_components(read.runs.count(header_.geometric_vertices)));
    triangles = std::move(read.triangles);
    open_edges_ = std::move(read.open_edges);
    runs_ = std::move(read.runs);
    if (triangles.capacity() / 5 > triangles.size() / 4) triangles.shrink_to_fit();
    return {};
  }

  /// m numbers, or none.
  Result<std::vector<std::uint32_t>> read_groups(std::span<const std::uint32_t> triangles) {
    DELTAMESH_TRY(const auto chunk, expand_single(container_, kTagFaceGroups));
    return is_plain_ ? read_plain_groups(chunk.bytes(), header_.triangles)
                     : read_face_groups(chunk.bytes(), triangles, header_.vertices);
  }

  Result<std::vector<GroupName>> read_names() const {
    const ChunkEntry* const entry = container_.find(kTagGroupNames);
    if (entry == nullptr || entry->decoded_bytes > kMostNamesBytes) return std::vector<GroupName>();
    DELTAMESH_TRY(const auto chunk, expand_chunk(container_, *entry));
    return read_group_names(chunk.bytes());
  }

  /// n x 3.
  Result<std::vector<float>> read_geometry(const std::vector<std::uint32_t>& triangles) {
    DELTAMESH_TRY(auto rows, header_.geometry == kGeometryPredictive ? read_predicted(geometric(triangles))
                                                                     : read_solved());
    if (is_split()) rows = copy_rows(rows, copies_);
    return rows;
  }

  bool is_split() const noexcept { return !copies_.empty(); }

  /// Faces over the geometric vertices, if `triangles` are those of the mesh.
  std::span<const std::uint32_t> geometric(const std::vector<std::uint32_t>& triangles) const noexcept {
    return is_split() ? geometric_triangles_ : triangles;
  }

  /// For the solution, which takes its graph apart. Where another thread may read attributes meanwhile these
  /// have their own.
  void build_graphs(const std::vector<std::uint32_t>& triangles) {
    graph_ = is_plain_
                 ? build_adjacency(geometric(triangles), header_.geometric_vertices)
                 : build_adjacency(geometric(triangles), open_edges_, header_.geometric_vertices, team_);
    geometric_triangles_ = std::vector<std::uint32_t>();  // which {} would not free
    if (header_.attributes.empty()) open_edges_ = LargeVector<DirectedEdge>();
    const auto takes_graph = [](const ChunkEntry& entry) {
      return entry.tag == kTagAttribute && entry.codec == ChunkCodec::kCompact;
    };
    const auto chunks = container_.entries();
    if (team_ != nullptr && !is_split() && std::any_of(chunks.begin(), chunks.end(), takes_graph))
      attribute_graph_ = graph_;
  }

  Result<std::vector<float>> read_predicted(std::span<const std::uint32_t> triangles) {
    if (is_of_grid_) {
      if (learnt_ != nullptr) learnt_->voxels = header_.predictive;
      return std::move(grid_positions_);
    }
    DELTAMESH_TRY(const auto payload, expand_single(container_, kTagPositions));
    if (is_plain_)
      return read_plain_positions(payload.bytes(), header_.geometric_vertices, header_.predictive);
    return read_positions(payload.bytes(), {triangles, header_.geometric_vertices}, header_.predictive,
                          header_.box(), of_lattice());
  }

  Learning<GridModels> of_grid() const {
    if (learnt_ != nullptr) learnt_->grid = std::make_unique<GridModels>(header_.predictive.levels);
    return {start_ != nullptr ? start_->grid.get() : nullptr,
            learnt_ != nullptr ? learnt_->grid.get() : nullptr};
  }
  Learning<OpModels> of_ops() const {
    return {start_ != nullptr ? start_->of_ops() : nullptr,
            learnt_ != nullptr ? &learnt_->ops.emplace() : nullptr};
  }
  Learning<LatticeModels> of_lattice() const {
    const bool learns = learnt_ != nullptr && header_.predictive.kind == PositionKind::kLattice;
    return {start_ != nullptr ? start_->of_lattice() : nullptr,
            learns ? &learnt_->lattice.emplace() : nullptr};
  }
  Learning<ColorModels> of_color(std::size_t attribute) const {
    const bool learns = learnt_ != nullptr && header_.attributes[attribute].kind == AttributeKind::kColor;
    return {start_ != nullptr ? start_->of_color(attribute) : nullptr,
            learns ? &learnt_->colors[attribute].emplace() : nullptr};
  }

  Result<void> check_components(std::uint32_t count) const {
    if (count == header_.components) return {};
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "the number of connected components differs from the header's",
                 .rule = "HDR-7"};
  }

  /// Of DELT or ANCH, which may be empty.
  Payload payload_of(const ExpandedChunk& chunk) const noexcept {
    return is_plain_ ? Payload(chunk.bytes()) : Payload::compact(chunk.bytes());
  }

  Result<std::vector<float>> read_solved() {
    Components components =
        is_plain_ ? find_components(graph_) : runs_.components(header_.geometric_vertices);
    DELTAMESH_TRY(const auto deltas, expand_single(container_, kTagDeltas));
    DELTAMESH_TRY(const auto anchors, expand_single(container_, kTagAnchors));
    DELTAMESH_TRY(const auto positions,
                  read_highpass(payload_of(deltas), payload_of(anchors), std::move(graph_),
                                std::move(components), header_.box(), header_.highpass, team_));
    return to_float_rows(positions);
  }

  /// `positions`: n x 3, or empty where attributes may not know them.
  Result<std::vector<Attribute>> read_attributes(std::span<const std::uint32_t> triangles,
                                                 std::span<const float> positions) {
    if (header_.attributes.empty()) return std::vector<Attribute>();
    const AttributeSurface surface(triangles, header_.vertices, copies_, positions,
                                   is_split() || is_of_grid_ ? nullptr : &open_edges_,
                                   std::exchange(attribute_graph_, std::nullopt));
    std::vector<Attribute> attributes(header_.attributes.size());
    DELTAMESH_CHECK(read_attributes_of(surface, false, attributes));
    DELTAMESH_CHECK(read_attributes_of(surface, true, attributes));
    return attributes;
  }

  /// Those that are decoded after others, or those that are not [ATTR-11].
  Result<void> read_attributes_of(const AttributeSurface& surface, bool after_others,
                                  std::vector<Attribute>& attributes) {
    std::size_t number = 0;
    for (const ChunkEntry& entry : container_.entries()) {
      if (entry.tag != kTagAttribute) continue;
      const std::size_t now = number++;
      const AttributeDescriptor& descriptor = header_.attributes[now];
      if (decoded_after_others(descriptor.kind) != after_others) continue;
      DELTAMESH_TRY(const auto chunk, expand_chunk(container_, entry));
      DELTAMESH_TRY(attributes[now],
                    read_attribute(chunk.payload(), descriptor, surface, attributes,
                                   options_.limits.attribute_bytes - attribute_bytes_, of_color(now)));
      attribute_bytes_ += attributes[now].values.size();
    }
    return {};
  }

  const Container& container_;
  const FileHeader& header_;
  const DecodeOptions& options_;
  bool is_plain_ = false;                           ///< the form of all chunks but attributes
  ThreadTeam* team_;                                ///< null: this thread alone
  const StreamModels* start_;                       ///< null: fresh models
  StreamModels* learnt_;                            ///< null where they are not wanted
  bool is_of_grid_;                                 ///< GRID has faces and positions
  std::vector<std::uint32_t> geometric_triangles_;  ///< empty where no vertex is split
  LargeVector<DirectedEdge> open_edges_;            ///< of the geometric faces
  std::vector<float> grid_positions_;               ///< n x 3 of a grid, until they are handed out
  VertexRuns runs_;                                 ///< of the geometric vertices
  std::vector<std::uint32_t> copies_;               ///< geometric vertex of every vertex; likewise
  Adjacency graph_;                                 ///< of the geometric vertices, until they are solved for
  std::optional<Adjacency> attribute_graph_;        ///< of all vertices, where it is made beforehand
  std::uint64_t attribute_bytes_ = 0;               ///< of the attributes read so far
};

}  // namespace

Result<Mesh> decode_container(const Container& container, const DecodeOptions& options, ThreadTeam* team,
                              StreamModels* learnt) {
  DELTAMESH_CHECK(check_limits(container.header(), options.limits));
  return StreamDecoder(container, options, team, learnt).run();
}

}  // namespace deltamesh
