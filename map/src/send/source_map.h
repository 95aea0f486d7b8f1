// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The newest source of every part of a sender's map, with revisions, groups and links [MAP-9, MAP-12].
#pragma once

#include <cstdint>
#include <map>
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
  bool is_copy = false;  ///< a coarser copy
  std::vector<PartLink> links{};
};

class SourceMap {
 public:
  SourceMap(Splitter splitter, std::uint8_t copy_level)
      : splitter_(std::move(splitter)), copy_level_(copy_level) {}

  void resume(std::uint64_t revision, std::uint64_t group) noexcept;
  /// Returns the parts that are gone.
  Result<std::vector<PartKey>> update(std::span<const MapBlock> blocks);

  /// Makes coarser copies [MAP-19] of these cells where they are not parts already, as
  /// Splitter::make_copies(). False: some are still to be made.
  Result<bool> make_copies(std::span<const PartKey> cells, std::uint64_t most_triangles);
  /// For a copy that was a part until what it was made of changed: the revision since when; else 0.
  std::uint64_t outdated_since(const PartKey& key) const {
    const auto found = outdated_.find(key);
    return found == outdated_.end() ? 0 : found->second;
  }
  /// Whether the part is a coarser copy.
  bool is_copy(const PartKey& key) const { return copies_.contains(key); }
  /// Of the copies that a receiver gets before anything else; 0: none would pay.
  std::uint8_t first_sight() const noexcept { return first_sight_; }

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
  void put(ChangedPart part, std::uint64_t revision, std::set<PartKey>& known_before);
  void take_out(const PartKey& key);
  void choose_first_sight();
  void number_groups(const std::set<PartKey>& members, const Pairs& pairs);

  Splitter splitter_;
  std::uint8_t copy_level_;
  std::uint8_t first_sight_ = 0;
  double chosen_for_ = 0;                        ///< triangles of the map, when that was chosen
  std::set<PartKey> copies_;                     ///< of the parts, those that are copies
  std::map<PartKey, std::uint64_t> outdated_{};  ///< copies that were parts, and since when not
  LinkTable table_;
  std::map<PartKey, SourcePart> parts_;
  std::uint64_t next_group_ = 0;
};

}  // namespace deltamesh
