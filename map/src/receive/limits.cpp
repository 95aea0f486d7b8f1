// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a receiver may hold.
#include <algorithm>

#include "part/view_cells.h"
#include "receive/state.h"

namespace deltamesh {
namespace {

constexpr std::size_t kLinksPerPart = 64;  // on average, at the most

/// All that counts for limits.
struct Sums {
  std::size_t parts = 0;
  std::uint64_t octets = 0;
  std::uint64_t vertices = 0;
  std::size_t links = 0;

  void add(const PartContent& content) {
    octets += content.octets.size();
    vertices += content.part.mesh.vertex_count();
  }
  void add(const Version& version) {
    links += version.links.size();
    if (version.content) add(*version.content);
  }
};

Sums sums_of(const ReceivedParts& parts) {
  Sums sums;
  for (const auto& [key, part] : parts.all()) {
    if (part.shown || !part.waiting.empty()) ++sums.parts;
    if (part.shown) sums.add(*part.shown);
    for (const Version& version : part.waiting) sums.add(version);
  }
  return sums;
}

}  // namespace

Error beyond_limits() noexcept {
  return {.code = ErrorCode::kLimitExceeded,
          .message = "more parts, bytes, vertices or links than the receiver may hold"};
}

bool MapReceiver::State::has_room_for_links() const {
  return sums_of(parts).links <= kLinksPerPart * limits.parts;
}

bool MapReceiver::State::make_room(const PartKey& but) {
  const MapDescription& description = codec->description();
  const PartKey* farthest = nullptr;
  double most = -1;
  for (const auto& [key, part] : parts.all()) {
    if ((!part.shown && part.waiting.empty()) || key == but || is_in_view(key, view, description)) continue;
    const double way = way_to(key, view, description);
    if (way > most) farthest = &key;
    most = std::max(most, way);
  }
  if (farthest == nullptr) return false;
  parts.drop(PartKey(*farthest), touched);
  parts.forget_replaced();
  return true;
}

/// For one more part of so many octets, which parts outside of the view make room for. What was replaced is
/// kept while all takes less than half of what it may. Errors: kLimitExceeded.
Result<DecodeOptions> MapReceiver::State::options_for(const PartKey& key, std::size_t octets) {
  for (;;) {
    const Sums sums = sums_of(parts);
    Sums all = sums;
    for (const auto& content : parts.replaced()) all.add(*content);
    if (2 * all.octets > limits.octets || 2 * all.vertices > limits.vertices) parts.forget_replaced();
    const ReceivedPart* part = parts.find(key);
    const bool is_held = part != nullptr && (part->shown || !part->waiting.empty());
    const bool is_full = (!is_held && sums.parts >= limits.parts) || sums.octets + octets > limits.octets ||
                         sums.vertices >= limits.vertices || sums.links > kLinksPerPart * limits.parts;
    // How many vertices it has is not known before it is decoded.
    const bool is_nearly_full = sums.vertices > limits.vertices - limits.vertices / 8;
    if ((is_full || is_nearly_full) && is_in_view(key, view, codec->description()) && make_room(key))
      continue;
    if (is_full) return beyond_limits();
    DecodeOptions options;
    options.limits.vertices = std::min(limits.vertices - sums.vertices, options.limits.vertices);
    return options;
  }
}

}  // namespace deltamesh
