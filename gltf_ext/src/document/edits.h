// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// New accessors for decoded arrays, and what becomes of the old ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "io/gltf/document.h"

namespace deltamesh::gltf {

/// Gives every decoded array an accessor of its own: the original's where nothing else refers to it, else a
/// new one at the end. Nothing is written before apply(): until then the originals may still be read.
class AccessorEdits {
 public:
  /// `kept`: accessors that stay as they are.
  AccessorEdits(Json& json, std::set<std::uint64_t> kept);

  const Json& original(std::size_t accessor) const { return (*json_)["accessors"][accessor]; }
  /// Whether something else refers to the accessor, or an array has it already.
  bool is_taken(std::size_t accessor) const { return taken_.count(accessor) != 0; }
  std::size_t replace(std::size_t accessor, Json described);
  std::size_t append(Json described);
  void apply();

 private:
  Json* json_;
  std::set<std::uint64_t> taken_;
  std::size_t next_;
  std::vector<std::pair<std::size_t, Json>> edits_;
};

/// Accessors that primitives, skins and animations name.
std::set<std::uint64_t> named_accessors(const Json& json);

/// Removes accessors in `before` that named_accessors() no longer has, and renumbers the others wherever core
/// glTF names them. Accessors that an unknown extension may mean keep their numbers.
void drop_unnamed_accessors(Json& json, const std::set<std::uint64_t>& before);

}  // namespace deltamesh::gltf
