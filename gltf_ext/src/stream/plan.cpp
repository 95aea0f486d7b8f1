// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/plan.h"

#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "base/try.h"
#include "base/union_find.h"
#include "stream/borders.h"
#include "stream/corners.h"

namespace deltamesh::gltf {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// What makes the vertices of two primitives the same: accessors with equal content in equal roles.
using VertexKey = std::pair<std::size_t, std::vector<std::pair<Semantic, std::size_t>>>;

VertexKey vertex_key(const AccessorStore& store, const PrimitiveSource& source) {
  std::map<Semantic, std::size_t> attributes;
  for (const SourceAttribute& attribute : source.attributes)
    attributes.emplace(attribute.semantic, store.canonical(attribute.accessor));
  return {store.canonical(source.position), {attributes.begin(), attributes.end()}};
}

/// What makes the triangles of two primitives the same, where their vertices are: mode and indices.
using TriangleKey = std::pair<TriangleMode, std::size_t>;

class Planner {
 public:
  Planner(const AccessorStore& store, const std::vector<PrimitiveSource>& sources)
      : store_(store), sources_(sources), clusters_(sources.size()) {}

  Result<std::vector<StreamPlan>> plan() {
    find_keys();
    join_meshes();
    DELTAMESH_CHECK(join_shared_vertices());
    std::vector<StreamPlan> plans;
    std::vector<std::size_t> plan_of(sources_.size(), kNone);
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      std::size_t& plan = plan_of[clusters_.find(i)];
      if (plan == kNone) {
        plan = plans.size();
        plans.emplace_back().exact_order = is_exact(i);
      }
      add(plans[plan], i);
    }
    for (const StreamPlan& plan : plans)
      if (plan.groups.size() > kMostGroups)
        return Error{.code = ErrorCode::kLimitExceeded, .message = "a mesh with more than 65536 primitives"};
    DELTAMESH_CHECK(mark_borders(store_, sources_, plans));
    return plans;
  }

 private:
  void find_keys() {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const auto [entry, is_new] = keys_.try_emplace(vertex_key(store_, sources_[i]), first_of_key_.size());
      if (is_new) {
        first_of_key_.push_back(i);
        exact_key_.push_back(false);
      }
      key_of_.push_back(entry->second);
      if (sources_[i].exact_order) exact_key_[entry->second] = true;
    }
  }

  bool is_exact(std::size_t i) const { return exact_key_[key_of_[i]]; }

  void join_meshes() {
    std::map<std::size_t, std::size_t> first_of_mesh;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (is_exact(i))
        clusters_.unite(i, first_of_key_[key_of_[i]]);
      else
        clusters_.unite(i, first_of_mesh.try_emplace(sources_[i].number.mesh, i).first->second);
    }
  }

  Result<void> join_shared_vertices() {
    constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
    std::map<std::size_t, std::vector<std::uint32_t>> users;  // by position accessor
    std::map<std::pair<std::size_t, TriangleKey>, std::size_t> done;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (is_exact(i)) continue;
      const PrimitiveSource& source = sources_[i];
      const std::size_t position = store_.canonical(source.position);
      const auto [same, is_new] = done.try_emplace({position, triangle_key(source)}, i);
      if (!is_new) {
        clusters_.unite(i, same->second);
        continue;
      }
      DELTAMESH_TRY(const auto corners, read_corners(store_, source));
      std::vector<std::uint32_t>& user = users[position];
      user.resize(static_cast<std::size_t>(store_.rows(position).shape().count), kNobody);
      for (const std::uint32_t corner : corners) {
        if (user[corner] == kNobody)
          user[corner] = static_cast<std::uint32_t>(i);
        else
          clusters_.unite(i, user[corner]);
      }
    }
    return {};
  }

  TriangleKey triangle_key(const PrimitiveSource& source) const {
    return {source.mode, source.indices ? store_.canonical(*source.indices) : kNone};
  }

  void add(StreamPlan& plan, std::size_t i) {
    const std::size_t first = clusters_.find(i);
    const auto [vertices, new_vertices] = vertices_.try_emplace({first, key_of_[i]}, plan.vertices.size());
    if (new_vertices) plan.vertices.push_back({i});
    const auto [group, new_group] =
        groups_.try_emplace({first, key_of_[i], triangle_key(sources_[i])}, plan.groups.size());
    if (new_group) plan.groups.push_back({.primitive = i, .vertices = vertices->second});
    plan.primitives.push_back(i);
    plan.group_of.push_back(static_cast<std::uint32_t>(group->second));
  }

  const AccessorStore& store_;
  const std::vector<PrimitiveSource>& sources_;
  UnionFind clusters_;
  std::map<VertexKey, std::size_t> keys_;
  std::vector<std::size_t> key_of_;        ///< of every primitive
  std::vector<std::size_t> first_of_key_;  ///< the first primitive that has the key
  std::vector<bool> exact_key_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> vertices_;              ///< by stream and key
  std::map<std::tuple<std::size_t, std::size_t, TriangleKey>, std::size_t> groups_;  ///< and by triangles
};

}  // namespace

Result<std::vector<StreamPlan>> plan_streams(const AccessorStore& store,
                                             const std::vector<PrimitiveSource>& sources) {
  return Planner(store, sources).plan();
}

}  // namespace deltamesh::gltf
