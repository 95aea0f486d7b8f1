// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/encode.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "connectivity/face_groups.h"
#include "encoder/attribute_stage.h"
#include "encoder/byte_budget.h"
#include "encoder/check_mesh.h"
#include "encoder/chunk_list.h"
#include "encoder/coded_topology.h"
#include "encoder/default_quality.h"
#include "encoder/geometry_stage.h"
#include "format/container.h"

namespace deltamesh {
namespace {

/// Stage ends as shares of the whole time, for the progress callback.
constexpr double kTopologyDone = 0.15;
constexpr double kGeometryDone = 0.75;
constexpr double kAttributesDone = 0.95;

/// The input vertex of every decoded vertex; in the input's order where that is kept.
std::vector<std::uint32_t> decoded_order(const CodedTopology& topology, bool keep_order) {
  std::vector<std::uint32_t> order = topology.vertex_order();
  if (keep_order) std::sort(order.begin(), order.end());
  return order;
}

/// No attribute loses a bit.
const AttributeQuality kExactly{.normal_error = 0, .tangent_error = 0, .uv_error = 0, .weight_error = 0};

/// One call of encode().
class MeshEncoder {
 public:
  /// The mesh has been checked, and so have the options.
  MeshEncoder(const MeshView& mesh, const EncodeOptions& options)
      : mesh_(mesh),
        options_(options),
        topology_(code_topology(mesh, options.keep_unreferenced,
                                is_compact_alone() ? PayloadForms::kCompact : PayloadForms::kBoth)),
        before_(options.profile, options.effort),
        after_(options.profile, options.effort),
        geometry_(mesh, topology_),
        attributes_(mesh, topology_, options_) {}

  Result<Encoded> run() {
    report_progress(kTopologyDone);
    DELTAMESH_CHECK(begin());
    DELTAMESH_TRY(const Parts parts, code_parts());
    DELTAMESH_CHECK(describe(parts.geometry, header_));
    header_.attributes = parts.attributes.descriptors;
    ChunkList chunks = std::move(before_);
    chunks.append(parts.geometry.chunks);
    chunks.append(parts.attributes.chunks);
    chunks.append(after_);

    Encoded encoded;
    encoded.bytes = write_container(header_, chunks.chunks());
    encoded.order = decoded_order(topology_, options_.keep_order);
    encoded.report.input_vertices = mesh_.vertex_count();
    encoded.report.unreferenced_vertices = topology_.unreferenced;
    DELTAMESH_TRY(encoded.report.stream, inspect(encoded.bytes));
    report_progress(1);
    return encoded;
  }

 private:
  /// What depends on each other.
  struct Parts {
    GeometryChoice geometry;
    CodedAttributes attributes;
  };

  void report_progress(double share) const {
    if (options_.progress) options_.progress(share);
  }

  /// A quick encode does not look whether another form is smaller.
  bool is_compact_alone() const noexcept {
    return options_.effort == 0 && options_.profile == Profile::kSmallest;
  }

  /// Header, and the chunks around geometry and attributes.
  Result<void> begin() {
    header_.keeps_order = options_.keep_order;
    header_.vertices = topology_.vertex_count();
    header_.geometric_vertices = topology_.geometric_count();
    header_.triangles = static_cast<std::uint32_t>(mesh_.triangle_count());
    header_.origin = mesh_.origin;
    geometry_.describe(header_);
    if (options_.lossless) options_.attributes = kExactly;

    CodedConnectivity& connectivity = topology_.connectivity;
    if (is_compact_alone()) {
      before_.add_compact(kTagConnectivity, std::move(connectivity.compact));
    } else {
      DELTAMESH_CHECK(
          before_.add(kTagConnectivity, std::move(connectivity.payload), std::move(connectivity.compact)));
    }
    DELTAMESH_CHECK(
        before_.add(kTagSeams, std::move(topology_.seams.payload), std::move(topology_.seams.compact)));
    DELTAMESH_CHECK(add_face_groups());
    if (options_.keep_order) {
      CodedOrder order = write_order(original_order(topology_, mesh_.vertex_count()), topology_.triangles());
      DELTAMESH_CHECK(after_.add(kTagOrder, std::move(order.payload), std::move(order.compact)));
    }
    return {};
  }

  QualityRequest default_request() const {
    return default_quality(topology_.connectivity.triangles, geometry_.positions(), header_.box());
  }

  /// The groups of the input's faces, if there are any.
  Result<void> add_face_groups() {
    if (mesh_.face_groups.empty()) return {};
    std::vector<std::uint32_t> groups;
    groups.reserve(mesh_.face_groups.size());
    for (const std::uint32_t face : topology_.connectivity.face_order)
      groups.push_back(mesh_.face_groups[face]);
    CodedFaceGroups coded =
        write_face_groups(std::move(groups), topology_.triangles(), topology_.vertex_count());
    if (!is_compact_alone())
      return before_.add(kTagFaceGroups, std::move(coded.payload), std::move(coded.compact));
    before_.add_compact(kTagFaceGroups, std::move(coded.compact));
    return {};
  }

  Result<Parts> code_parts() {
    const bool asks_nothing = asks_for_nothing(options_);
    if (asks_nothing) options_.quality = default_request();
    auto parts = shares_bytes() ? share_bytes() : code_asked(options_);
    if (parts || !asks_nothing || parts.error().code != ErrorCode::kUnmetRequest) return parts;
    // A highpass stream, where the profile asks for one, may not reach the default: the best that it can do.
    options_.quality = {};
    options_.bits = 16;
    return code_asked(options_);
  }

  /// Attributes within their own bounds, on the geometry that keeps its own.
  Result<Parts> code_asked(const EncodeOptions& options) const {
    AttributeBytes attribute_bytes;
    if (attributes_.uses_positions()) {
      attribute_bytes = [&](std::span<const float> positions) -> Result<std::uint64_t> {
        DELTAMESH_TRY(const auto coded, attributes_.code(options.attributes, positions));
        return coded.bytes();
      };
    }
    DELTAMESH_TRY(auto geometry, geometry_.code(options, {header_, before_, after_}, attribute_bytes));
    report_progress(kGeometryDone);
    DELTAMESH_TRY(auto attributes, attributes_.code(options.attributes, geometry.positions));
    report_progress(kAttributesDone);
    return Parts{std::move(geometry), std::move(attributes)};
  }

  bool shares_bytes() const noexcept { return options_.quality.target_bytes && !mesh_.attributes.empty(); }

  ChunkList beside(const CodedAttributes& attributes) const {
    ChunkList after = attributes.chunks;
    after.append(after_);
    return after;
  }

  FileHeader header_of(const CodedAttributes& attributes) const {
    FileHeader header = header_;
    header.attributes = attributes.descriptors;
    return header;
  }

  /// The best geometry in what these attributes leave of the bytes.
  Result<GeometryChoice> code_beside(const EncodeOptions& options, const CodedAttributes& attributes) const {
    return geometry_.code(options, {header_of(attributes), before_, beside(attributes)});
  }

  std::uint64_t bytes_of(const GeometryChoice& geometry, const CodedAttributes& attributes) const {
    return StreamFrame{header_of(attributes), before_, beside(attributes)}.bytes_with(geometry);
  }

  /// Attributes and positions share the bytes, unless positions have bounds of their own.
  Result<Parts> share_bytes() const {
    const QualityRequest& quality = options_.quality;
    const bool bytes_alone = !quality.vde && !quality.lfe && !quality.max_error;
    if (!bytes_alone) return fit_bytes();
    const double unit = default_request().max_error->value;
    std::optional<Parts> best;
    std::uint64_t fewest = ~std::uint64_t{0};
    ScaleSearch search(*quality.target_bytes);
    for (int i = 0; i < 6 + options_.effort && !search.is_done(); ++i) {
      EncodeOptions options = options_;
      options.quality = {.max_error = QualityBound{search.scale() * unit}};
      options.attributes = scaled(options_.attributes, search.scale());
      DELTAMESH_TRY(Parts parts, code_asked(options));
      const std::uint64_t bytes = bytes_of(parts.geometry, parts.attributes);
      fewest = std::min(fewest, bytes);
      if (search.tell(bytes)) best = std::move(parts);
    }
    if (search.has_room() && options_.profile == Profile::kSmallest &&
        options_.geometry != GeometryCoder::kHighpass) {
      EncodeOptions options = options_;
      options.quality = {};
      options.lossless = true;
      options.attributes = kExactly;
      DELTAMESH_TRY(Parts parts, code_asked(options));
      if (bytes_of(parts.geometry, parts.attributes) <= *quality.target_bytes) return parts;
    }
    if (best) return *std::move(best);
    return too_few_bytes(fewest);
  }

  static Error too_few_bytes(std::uint64_t fewest) noexcept {
    return {.code = ErrorCode::kUnmetRequest,
            .message = "no stream of this mesh is so small",
            .best_bytes = fewest};
  }

  /// The best geometry beside attributes within their bounds, in no more than the bytes asked for. What
  /// these take depends on the positions, and what is left for positions on the attributes.
  Result<Parts> fit_bytes() const {
    std::optional<Parts> best;
    DELTAMESH_TRY(CodedAttributes attributes, attributes_.code(options_.attributes, {}));
    std::uint64_t fewest = ~std::uint64_t{0};
    for (int i = 0; i < kMostFits; ++i) {
      auto geometry = code_beside(options_, attributes);
      if (!geometry && !best) return geometry.error();
      if (!geometry) break;
      DELTAMESH_TRY(attributes, attributes_.code(options_.attributes, geometry->positions));
      const std::uint64_t bytes = bytes_of(*geometry, attributes);
      fewest = std::min(fewest, bytes);
      if (bytes <= *options_.quality.target_bytes)
        best = Parts{*std::move(geometry), attributes};
      else if (best)
        break;
    }
    report_progress(kAttributesDone);
    if (best) return *std::move(best);
    return too_few_bytes(fewest);
  }

  static constexpr int kMostFits = 3;

  const MeshView& mesh_;
  EncodeOptions options_;
  CodedTopology topology_;
  FileHeader header_;
  ChunkList before_;
  ChunkList after_;
  GeometryStage geometry_;
  AttributeStage attributes_;
};

}  // namespace

Result<Encoded> encode(const MeshView& mesh, const EncodeOptions& options) noexcept {
  return guarded([&]() -> Result<Encoded> {
    DELTAMESH_CHECK(validate(options));
    DELTAMESH_CHECK(check_mesh(mesh));
    return MeshEncoder(mesh, options).run();
  });
}

}  // namespace deltamesh
