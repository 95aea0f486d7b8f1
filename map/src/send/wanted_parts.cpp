// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/wanted_parts.h"

#include <vector>

#include "part/view_cells.h"

namespace deltamesh {
namespace {

class Wants {
 public:
  Wants(const Viewer& viewer, const SourceMap& map, const MapDescription& description) {
    for (const auto& [key, part] : map.parts())
      if (is_in_view(key, viewer.view, description)) in_view_.insert(key);
    for (const auto& [key, believed] : viewer.has) {
      if (believed.is_gone) continue;
      for (int level = key.level; level <= highest(); ++level)
        if (const PartKey above = ancestor(key, static_cast<std::uint8_t>(level)); in_view_.contains(above))
          begun_.insert(above);
    }
  }

  WantedParts run() {
    // From the finest on, each is found by what is nearest above it.
    for (const PartKey& key : in_view_) inside_[holder_of(key)].push_back(key);
    WantedParts parts;
    std::vector<PartKey> open = inside_[kNone];
    while (!open.empty()) {
      const PartKey key = open.back();
      open.pop_back();
      const auto inside = inside_.find(key);
      if (inside == inside_.end() || !begun_.contains(key)) {
        parts.wanted.insert(key);
      } else {
        open.insert(open.end(), inside->second.begin(), inside->second.end());
      }
    }
    for (const PartKey& key : in_view_)
      if (!parts.wanted.contains(key)) parts.others.insert(key);
    return parts;
  }

 private:
  static constexpr PartKey kNone{kMostPartLevel + 1, 0, 0, 0};

  int highest() const noexcept { return in_view_.empty() ? -1 : in_view_.rbegin()->level; }

  PartKey holder_of(const PartKey& key) const {
    for (int level = key.level + 1; level <= highest(); ++level)
      if (const PartKey above = ancestor(key, static_cast<std::uint8_t>(level)); in_view_.contains(above))
        return above;
    return kNone;
  }

  std::set<PartKey> in_view_;
  std::set<PartKey> begun_;  ///< the receiver has it, or something in its cell
  std::map<PartKey, std::vector<PartKey>> inside_;
};

}  // namespace

WantedParts wanted_parts(const Viewer& viewer, const SourceMap& map, const MapDescription& description) {
  return Wants(viewer, map, description).run();
}

}  // namespace deltamesh
