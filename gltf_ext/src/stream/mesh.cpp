// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "stream/corners.h"
#include "stream/geometry.h"
#include "stream/row_pool.h"

namespace deltamesh::gltf {
namespace {

constexpr std::size_t kPositionBytes = 3 * sizeof(float);
constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

Error not_finite(const PrimitiveSource& source, std::size_t vertex) noexcept {
  Error error = at_primitive({.code = ErrorCode::kNotFinite, .message = "a coordinate is NaN or infinite"},
                             source.number);
  error.where_kind = WhereKind::kVertex;
  error.where = vertex;
  return error;
}

class Merger {
 public:
  Merger(const AccessorStore& store, const std::vector<PrimitiveSource>& sources, const StreamPlan& plan,
         const MergeOptions& options)
      : store_(store), sources_(sources), plan_(plan), options_(options) {}

  Result<StreamMesh> merge() {
    find_attributes();
    if (result_.attributes.size() > DecodeLimits{}.attributes)
      return at_primitive({.code = ErrorCode::kLimitExceeded,
                           .message = "the primitives of a mesh have too many different attributes"},
                          sources_[plan_.primitives.front()].number);
    DELTAMESH_CHECK(read_triangles());
    RowPool pool(row_size_);
    for (std::size_t v = 0; v < plan_.vertices.size(); ++v) DELTAMESH_CHECK(add_vertices(v, pool));
    for (std::size_t g = 0; g < plan_.groups.size(); ++g) add_group(g);
    split_rows(pool);
    fill_normals();
    for (const std::size_t primitive : plan_.primitives)
      result_.uv_scale = std::max(result_.uv_scale, sources_[primitive].uv_scale);
    result_.smallest_diagonal = smallest_diagonal_share(result_.mesh, corners_, sources_, plan_);
    return std::move(result_);
  }

 private:
  const PrimitiveSource& source_of(const VertexSource& vertices) const {
    return sources_[vertices.primitive];
  }

  void find_attributes() {
    row_size_ = kPositionBytes;
    for (const VertexSource& vertices : plan_.vertices) {
      const PrimitiveSource& source = source_of(vertices);
      for (const SourceAttribute& attribute : source.attributes) {
        const std::size_t known = stream_attribute(result_.attributes, store_, source, attribute);
        if (known < result_.attributes.size()) continue;
        const AccessorShape& shape = store_.rows(attribute.accessor).shape();
        result_.attributes.push_back({attribute.semantic, shape});
        offsets_.push_back(row_size_);
        row_size_ += shape.row_size();
      }
    }
  }

  /// Corners of every group, and which vertices they use.
  Result<void> read_triangles() {
    constexpr std::uint64_t kMostRows = std::uint64_t{1} << 29;  // bounds memory where rows are used often
    std::uint64_t rows = 0;
    for (const VertexSource& vertices : plan_.vertices)
      rows = saturating_add(rows, store_.rows(source_of(vertices).position).shape().count);
    if (rows > kMostRows)
      return Error{.code = ErrorCode::kLimitExceeded, .message = "a mesh with too many vertices"};
    for (const VertexSource& vertices : plan_.vertices)
      numbers_.emplace_back(static_cast<std::size_t>(store_.rows(source_of(vertices).position).shape().count),
                            options_.keep_all ? 0 : kNoVertex);
    for (const TriangleSource& group : plan_.groups) {
      DELTAMESH_TRY(auto corners, read_corners(store_, sources_[group.primitive]));
      if (options_.drop_degenerate)
        result_.degenerate_triangles += drop_degenerate(store_, sources_[group.primitive], corners);
      for (const std::uint32_t corner : corners) numbers_[group.vertices][corner] = 0;
      corners_.push_back(std::move(corners));
    }
    return {};
  }

  Result<void> add_vertices(std::size_t v, RowPool& pool) {
    const PrimitiveSource& source = source_of(plan_.vertices[v]);
    const AccessorRows& positions = store_.rows(source.position);
    std::vector<std::byte> row(row_size_);
    std::vector<const AccessorRows*> columns(result_.attributes.size());
    for (const SourceAttribute& attribute : source.attributes)
      columns[stream_attribute(result_.attributes, store_, source, attribute)] =
          &store_.rows(attribute.accessor);
    for (std::size_t a = 0; a < columns.size(); ++a) {
      const StreamAttribute& attribute = result_.attributes[a];
      const auto filler = filler_row(kind_of(attribute.semantic, attribute.shape), attribute.shape);
      std::ranges::copy(filler, row.begin() + static_cast<std::ptrdiff_t>(offsets_[a]));
    }
    for (std::size_t i = 0; i < numbers_[v].size(); ++i) {
      if (numbers_[v][i] == kNoVertex) {
        ++result_.unreferenced_vertices;
        continue;
      }
      const Vec3 coordinates = vector_at(positions, i);
      std::array<float, 3> position{};
      for (std::size_t k = 0; k < 3; ++k) {
        float& x = position[k] = static_cast<float>(coordinates[k]);
        if (options_.one_zero) x += 0.0F;
        if (!std::isfinite(x)) return not_finite(source, i);
      }
      std::memcpy(row.data(), position.data(), kPositionBytes);
      for (std::size_t a = 0; a < columns.size(); ++a)
        if (columns[a])
          std::ranges::copy(columns[a]->row(i), row.begin() + static_cast<std::ptrdiff_t>(offsets_[a]));
      if (pool.size() == kNoVertex - 1)
        return Error{.code = ErrorCode::kLimitExceeded, .message = "a mesh with too many vertices"};
      const std::uint32_t before = pool.size();
      numbers_[v][i] = options_.weld ? pool.find_or_append(row) : pool.append(row);
      if (pool.size() == before) ++result_.welded_vertices;
    }
    for (std::size_t a = 0; a < columns.size(); ++a)
      if (!columns[a]) lacking_.push_back({v, a});
    return {};
  }

  void add_group(std::size_t g) {
    const std::vector<std::uint32_t>& numbers = numbers_[plan_.groups[g].vertices];
    std::vector<std::uint32_t>& triangles = result_.mesh.triangles;
    for (std::uint32_t& corner : corners_[g]) corner = numbers[corner];
    triangles.insert(triangles.end(), corners_[g].begin(), corners_[g].end());
    if (plan_.groups.size() > 1)
      result_.mesh.face_groups.resize(triangles.size() / 3, static_cast<std::uint32_t>(g));
  }

  void split_rows(const RowPool& pool) {
    Mesh& mesh = result_.mesh;
    mesh.positions.resize(pool.size() * std::size_t{3});
    for (std::uint32_t i = 0; i < pool.size(); ++i)
      std::memcpy(&mesh.positions[i * std::size_t{3}], pool.row(i).data(), kPositionBytes);
    for (std::size_t a = 0; a < result_.attributes.size(); ++a) {
      const auto& [semantic, shape] = result_.attributes[a];
      const std::size_t size = shape.row_size();
      Attribute& attribute = mesh.attributes.emplace_back();
      attribute.kind = kind_of(semantic, shape);
      attribute.type = shape.type;
      attribute.components = shape.components;
      attribute.normalized = shape.normalized;
      attribute.linear = attribute.kind == AttributeKind::kColor;
      attribute.name = stream_name(semantic, shape);
      attribute.values.resize(pool.size() * size);
      for (std::uint32_t i = 0; i < pool.size(); ++i)
        std::memcpy(attribute.values.data() + i * size, pool.row(i).data() + offsets_[a], size);
    }
  }

  /// Gives vertices without a normal that of the faces around, which decoders compute: it costs next to
  /// nothing.
  void fill_normals() {
    for (const auto& [v, a] : lacking_) {
      Attribute& attribute = result_.mesh.attributes[a];
      if (attribute.kind != AttributeKind::kNormal) continue;
      for (std::size_t g = 0; g < plan_.groups.size(); ++g)
        if (plan_.groups[g].vertices == v) write_face_normals(result_.mesh, corners_[g], attribute.values);
    }
  }

  const AccessorStore& store_;
  const std::vector<PrimitiveSource>& sources_;
  const StreamPlan& plan_;
  const MergeOptions& options_;
  StreamMesh result_;
  std::size_t row_size_ = 0;
  std::vector<std::size_t> offsets_;                 ///< of every attribute in a row
  std::vector<std::vector<std::uint32_t>> numbers_;  ///< by vertex source: the mesh's vertex for its own
  std::vector<std::vector<std::uint32_t>> corners_;  ///< by group
  std::vector<std::pair<std::size_t, std::size_t>> lacking_;  ///< vertex sources, and attributes they lack
};

}  // namespace

std::size_t stream_attribute(const std::vector<StreamAttribute>& attributes, const AccessorStore& store,
                             const PrimitiveSource& source, const SourceAttribute& attribute) {
  const AccessorShape& shape = store.rows(attribute.accessor).shape();
  // The first attribute of the primitive that is the same stands for all.
  const auto first = std::ranges::find_if(source.attributes, [&](const SourceAttribute& other) {
    return store.canonical(other.accessor) == store.canonical(attribute.accessor) &&
           kind_of(other.semantic, shape) == kind_of(attribute.semantic, shape) &&
           stream_name(other.semantic, shape) == stream_name(attribute.semantic, shape);
  });
  const auto found = std::ranges::find_if(attributes, [&](const StreamAttribute& known) {
    return known.semantic == first->semantic && known.shape.same_rows(shape);
  });
  return static_cast<std::size_t>(found - attributes.begin());
}

Result<StreamMesh> merge_primitives(const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
                                    const StreamPlan& plan, const MergeOptions& options) {
  return Merger(store, sources, plan, options).merge();
}

}  // namespace deltamesh::gltf
