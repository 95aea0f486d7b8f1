// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The newest source of every part of a sender's map, with revisions, groups and links [MAP-9, MAP-12].
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "deltamesh/map/split.h"
#include "part/link_table.h"

namespace deltamesh {

struct SourcePart {
  MapPart part;
  std::uint64_t content_revision = 0;  ///< when the mesh or its border changed
  std::uint64_t revision = 0;          ///< when that or a link changed
  std::uint64_t group = 0;
  std::vector<PartLink> links{};
};

class SourceMap {
 public:
  explicit SourceMap(Splitter splitter) : splitter_(std::move(splitter)) {}

  void resume(std::uint64_t revision, std::uint64_t group) noexcept;
  /// Returns the parts that are gone.
  Result<std::vector<PartKey>> update(std::span<const MapBlock> blocks);

  const std::map<PartKey, SourcePart>& parts() const noexcept { return parts_; }
  const SourcePart* find(const PartKey& key) const noexcept;
  std::uint64_t revision() const noexcept { return splitter_.revision(); }
  std::uint64_t next_group() const noexcept { return next_group_; }
  /// Links as the entry of a removal has them [MAP-13]: of a part that is gone, to what is in its cell's
  /// place.
  std::vector<PartLink> replacements_of(const PartKey& key) const;
  /// The same of a part that is in the map, but that copies take the place of. `wanted`: parts that the
  /// receiver is to have.
  std::vector<PartLink> copies_in_place_of(const PartKey& key, const std::set<PartKey>& wanted) const;

 private:
  using Pairs = std::vector<std::pair<PartKey, PartKey>>;
  void relink(const std::set<PartKey>& touched, const std::set<PartKey>& changed,
              const std::set<PartKey>& known_before);
  void number_groups(const std::set<PartKey>& members, const Pairs& pairs);

  Splitter splitter_;
  LinkTable table_;
  std::map<PartKey, SourcePart> parts_;
  std::uint64_t next_group_ = 0;
};

}  // namespace deltamesh
