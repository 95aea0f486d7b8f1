// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a receiver may hold.
#include <algorithm>

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

/// For one more part of so many octets. What was replaced is kept while all takes less than half of what it
/// may. Errors: kLimitExceeded.
Result<DecodeOptions> MapReceiver::State::options_for(const PartKey& key, std::size_t octets) {
  const Sums sums = sums_of(parts);
  Sums all = sums;
  for (const auto& content : parts.replaced()) all.add(*content);
  if (2 * all.octets > limits.octets || 2 * all.vertices > limits.vertices) parts.forget_replaced();
  const ReceivedPart* part = parts.find(key);
  const bool is_held = part != nullptr && (part->shown || !part->waiting.empty());
  if ((!is_held && sums.parts >= limits.parts) || sums.octets + octets > limits.octets ||
      sums.vertices >= limits.vertices || sums.links > kLinksPerPart * limits.parts)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more parts than the receiver may hold"};
  DecodeOptions options;
  options.limits.vertices = std::min(limits.vertices - sums.vertices, options.limits.vertices);
  return options;
}

}  // namespace deltamesh
