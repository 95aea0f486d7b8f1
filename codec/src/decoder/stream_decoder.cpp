// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "decoder/stream_decoder.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "attributes/attribute.h"
#include "base/guard.h"
#include "base/memory/large_vector.h"
#include "base/small_code.h"
#include "base/threads/task.h"
#include "base/threads/thread_team.h"
#include "base/try.h"
#include "connectivity/groups/groups.h"
#include "connectivity/order/order.h"
#include "connectivity/plain/topology.h"
#include "decoder/stream_faces.h"
#include "decoder/stream_learning.h"
#include "deltamesh/model_states.h"
#include "entropy/expand_chunk.h"
#include "format/chunk/kinds.h"
#include "format/vertex_positions.h"
#include "highpass/highpass.h"
#include "positions/plain.h"
#include "positions/positions.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

constexpr double kGeometryDone = 0.85;

void report_progress(const DecodeOptions& options, double share) {
  if (options.progress) call_back(options.progress, share);
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
        learning_(header_, options.starting_states != nullptr ? &options.starting_states->models() : nullptr,
                  learnt) {}

  Result<Mesh> run() {
    Mesh mesh;
    mesh.origin = header_.origin;
    DELTAMESH_CHECK(check_form());
    DELTAMESH_TRY(faces_, is_plain_ ? read_plain_stream_faces(container_)
                                    : read_stream_faces(container_, learning_, options_.known));
    DELTAMESH_TRY(mesh.face_groups, read_groups());
    if constexpr (!kSmallCode) {  // no module hands them out
      DELTAMESH_TRY(mesh.group_names, read_names());
    }
    if (header_.geometry == kGeometryPredictive) {
      DELTAMESH_TRY(mesh.positions, read_geometry());
      report_progress(options_, kGeometryDone);
      DELTAMESH_TRY(mesh.attributes, read_attributes(mesh.positions));
    } else {
      build_graphs();
      // Nothing that is parsed may depend on solved positions [ATTR-10], so both can go on at a time.
      Task attributes(team_, [&] { return read_attributes({}); });
      DELTAMESH_TRY(mesh.positions, read_geometry());
      report_progress(options_, kGeometryDone);
      DELTAMESH_TRY(mesh.attributes, attributes.get());
    }
    mesh.triangles = std::move(faces_.triangles);
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
    if (is_of_grid(header_) && !is_compact)
      return Error{.code = ErrorCode::kInvalidStream, .message = "a grid in the plain form", .rule = "PLN-1"};
    if (!is_plain_ || !is_compact) {
      is_plain_ = !is_compact;
      return {};
    }
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "chunks of the plain form beside those of the compact form",
                 .rule = "PLN-1"};
  }

  /// m numbers, or none.
  Result<std::vector<std::uint32_t>> read_groups() {
    DELTAMESH_TRY(const auto chunk, expand_single(container_, kTagFaceGroups));
    return is_plain_ ? read_plain_groups(chunk.bytes(), header_.triangles)
                     : read_face_groups(chunk.bytes(), faces_.triangles, header_.vertices);
  }

  Result<std::vector<GroupName>> read_names() const {
    const ChunkEntry* const entry = container_.find(kTagGroupNames);
    if (entry == nullptr || entry->decoded_bytes > kMostNamesBytes) return std::vector<GroupName>();
    DELTAMESH_TRY(const auto chunk, expand_chunk(container_, *entry));
    return read_group_names(chunk.bytes());
  }

  /// n x 3.
  Result<std::vector<float>> read_geometry() {
    DELTAMESH_TRY(auto rows, header_.geometry == kGeometryPredictive ? read_predicted() : read_solved());
    if (faces_.is_split()) rows = copy_rows(rows, faces_.copies);
    return rows;
  }

  /// For the solution, which takes its graph apart. Where another thread may read attributes meanwhile these
  /// have their own.
  void build_graphs() {
    graph_ = is_plain_
                 ? build_adjacency(faces_.geometric(), header_.geometric_vertices)
                 : build_adjacency(faces_.geometric(), faces_.open_edges, header_.geometric_vertices, team_);
    faces_.split = std::vector<std::uint32_t>();  // which {} would not free
    if (header_.attributes.empty()) faces_.open_edges = LargeVector<DirectedEdge>();
    const auto takes_graph = [](const ChunkEntry& entry) {
      return entry.tag == kTagAttribute && entry.codec == ChunkCodec::kCompact;
    };
    const auto chunks = container_.entries();
    if (team_ != nullptr && !faces_.is_split() && std::any_of(chunks.begin(), chunks.end(), takes_graph))
      attribute_graph_ = graph_;
  }

  Result<std::vector<float>> read_predicted() {
    if (is_of_grid(header_)) return std::move(faces_.grid_positions);
    DELTAMESH_TRY(const auto payload, expand_single(container_, kTagPositions));
    if (is_plain_)
      return read_plain_positions(payload.bytes(), header_.geometric_vertices, header_.predictive);
    return read_positions(payload.bytes(), {faces_.geometric(), header_.geometric_vertices},
                          header_.predictive, header_.box(), learning_.of_lattice());
  }

  /// Of DELT or ANCH, which may be empty.
  Payload payload_of(const ExpandedChunk& chunk) const noexcept {
    return is_plain_ ? Payload(chunk.bytes()) : Payload::compact(chunk.bytes());
  }

  Result<std::vector<float>> read_solved() {
    Components components =
        is_plain_ ? find_components(graph_) : faces_.runs.components(header_.geometric_vertices);
    DELTAMESH_TRY(const auto deltas, expand_single(container_, kTagDeltas));
    DELTAMESH_TRY(const auto anchors, expand_single(container_, kTagAnchors));
    DELTAMESH_TRY(const auto positions,
                  read_highpass(payload_of(deltas), payload_of(anchors), std::move(graph_),
                                std::move(components), header_.box(), header_.highpass, team_));
    return to_float_rows(positions);
  }

  /// `positions`: n x 3, or empty where attributes may not know them.
  Result<std::vector<Attribute>> read_attributes(std::span<const float> positions) {
    if (header_.attributes.empty()) return std::vector<Attribute>();
    const bool has_edges = !faces_.is_split() && !is_of_grid(header_);
    AttributeSurface surface(faces_.triangles, header_.vertices, faces_.copies, positions,
                             has_edges ? &faces_.open_edges : nullptr,
                             std::exchange(attribute_graph_, std::nullopt));
    surface.set_known(faces_.known);
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
      const Attribute* const known =
          known_attribute(options_.known, now, descriptor.type, descriptor.components);
      DELTAMESH_TRY(attributes[now], read_attribute(chunk.payload(), descriptor, surface, attributes,
                                                    options_.limits.attribute_bytes - attribute_bytes_,
                                                    learning_.of_attribute(now), known));
      attribute_bytes_ += attributes[now].values.size();
    }
    return {};
  }

  const Container& container_;
  const FileHeader& header_;
  const DecodeOptions& options_;
  ThreadTeam* team_;  ///< null: this thread alone
  StreamLearning learning_;
  bool is_plain_ = false;  ///< the form of all chunks but attributes
  StreamFaces faces_;
  Adjacency graph_;                           ///< of the geometric vertices, until they are solved for
  std::optional<Adjacency> attribute_graph_;  ///< of all vertices, where it is made beforehand
  std::uint64_t attribute_bytes_ = 0;         ///< of the attributes read so far
};

}  // namespace

Result<Mesh> decode_container(const Container& container, const DecodeOptions& options, ThreadTeam* team,
                              StreamModels* learnt) {
  DELTAMESH_CHECK(check_limits(container.header(), options.limits));
  return StreamDecoder(container, options, team, learnt).run();
}

}  // namespace deltamesh
