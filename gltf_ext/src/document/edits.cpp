// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/edits.h"

#include "document/references.h"
#include "document/renumber.h"
#include "io/gltf/structure.h"

namespace deltamesh::gltf {
namespace {

/// Calls `visit(number)`, a Json, for every reference that core glTF makes.
template <class JsonType, class Visit>
void for_each_accessor_reference(JsonType& json, Visit&& visit) {
  for_each_other_accessor(json, visit);
  for_each_primitive(json, [&](auto& primitive, const PrimitiveNumber&) {
    for (auto& accessor : primitive["attributes"]) visit(accessor);
    if (auto* targets = find(primitive, "targets"))
      for (auto& target : *targets)
        for (auto& accessor : target) visit(accessor);
    if (auto* indices = find(primitive, "indices")) visit(*indices);
  });
}

}  // namespace

AccessorEdits::AccessorEdits(Json& json, std::set<std::uint64_t> kept)
    : json_(&json), taken_(std::move(kept)), next_(array_size(json, "accessors")) {}

std::size_t AccessorEdits::replace(std::size_t accessor, Json described) {
  if (!taken_.insert(accessor).second) return append(std::move(described));
  edits_.emplace_back(accessor, std::move(described));
  return accessor;
}

std::size_t AccessorEdits::append(Json described) {
  edits_.emplace_back(next_, std::move(described));
  return next_++;
}

void AccessorEdits::apply() {
  if (edits_.empty()) return;
  Json& accessors = (*json_)["accessors"];
  while (accessors.size() < next_) accessors.push_back(Json::object());
  for (auto& [number, described] : edits_) accessors[number] = std::move(described);
  edits_.clear();
}

std::set<std::uint64_t> named_accessors(const Json& json) {
  std::set<std::uint64_t> named;
  for_each_accessor_reference(json, [&](const Json& number) { named.insert(number.get<std::uint64_t>()); });
  return named;
}

void drop_unnamed_accessors(Json& json, const std::set<std::uint64_t>& before) {
  const auto named = named_accessors(json);
  std::vector<bool> used(array_size(json, "accessors"), true);
  for (const std::uint64_t accessor : before)
    if (named.count(accessor) == 0) used[static_cast<std::size_t>(accessor)] = false;
  const Renumbering numbers = renumber(used, numbers_in_unknown_extensions(json));
  if (numbers.old_of_new.empty()) return;
  reorder(json["accessors"], numbers);
  for_each_accessor_reference(json,
                              [&](Json& number) { number = numbers.new_of_old[number.get<std::size_t>()]; });
}

}  // namespace deltamesh::gltf
