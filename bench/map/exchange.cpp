// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map/exchange.h"

#include <algorithm>
#include <vector>

#include "deltamesh/compare.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "support/errors.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

/// Adds the seconds of `work` to `sum`.
template <class Work>
void add_seconds(double& sum, Work&& work) {
  const double start = processor_seconds();
  work();
  sum += processor_seconds() - start;
}

/// With primers from the parts of the first update.
MapDescription primed(const MapUpdates& updates, const Bounds& bounds, const SenderOptions& options) {
  const MapDescription description = map_description(updates, bounds.max_error);
  Splitter splitter = value_or_exit(Splitter::make(description, options.split));
  std::vector<MapBlock> blocks;
  for (const SequenceBlock& block : updates.steps.front().changed) blocks.push_back({block.id, block.mesh});
  const MapChange change = value_or_exit(splitter.update(blocks));
  std::vector<MapPart> parts;
  for (const ChangedPart& changed : change.changed) parts.push_back(changed.part);
  PartQuality quality;
  quality.bounds.max_error = QualityBound{bounds.max_error};
  quality.attributes = quality_of(bounds);
  quality.effort = bounds.effort;
  return value_or_exit(with_primers(description, parts, quality));
}

Mesh join_parts(const MapReceiver& receiver, const std::vector<PartKey>& keys) {
  std::vector<MapPart> parts;
  for (const PartKey& key : keys) parts.push_back(*receiver.find(key));
  return value_or_exit(join(parts));
}

void join_changed(MapReceiver& receiver) { join_parts(receiver, receiver.take_change().changed); }

double error_of(const MapReceiver& receiver, const Mesh& source) {
  const Mesh joined = join_parts(receiver, receiver.shown());
  const Comparison comparison = value_or_exit(compare(source, joined));
  return comparison.corresponding ? comparison.quality.max_error : comparison.surface_max;
}

}  // namespace

AttributeQuality quality_of(const Bounds& bounds) {
  if (bounds.color_rms > 0) return {.color_rms = bounds.color_rms};
  return {.color_error = bounds.color_error};
}

Sums run_map(const MapUpdates& updates, const Bounds& bounds, const ExchangeSettings& settings) {
  SenderOptions options;
  options.split.most_triangles = settings.most_triangles;
  options.effort = bounds.effort;
  options.keeps_good_enough = settings.keeps_good_enough;
  const MapDescription description = primed(updates, bounds, options);
  MapSender sender = value_or_exit(MapSender::make(description, options));
  MapReceiver receiver(1, description.id);
  View view;
  view.max_error = static_cast<float>(bounds.max_error);
  if (bounds.color_rms > 0)
    view.color_rms = static_cast<float>(bounds.color_rms);
  else
    view.color_error = static_cast<float>(bounds.color_error);
  receiver.set_view(view);
  Sums sums;
  double now = 0;
  const auto exchange = [&] {
    check_or_exit(sender.hear(value_or_exit(receiver.view_message()), now += 2));
    std::vector<std::vector<std::byte>> messages;
    add_seconds(sums.encode, [&] { messages = value_or_exit(sender.messages_for(1, now)); });
    for (const auto& message : messages) sums.bytes += message.size();
    add_seconds(sums.decode, [&] {
      for (const auto& message : messages) check_or_exit(receiver.apply(message));
    });
  };
  exchange();  // the map's message
  for (std::size_t i = 0; i < updates.steps.size(); ++i) {
    const Mesh nothing;
    std::vector<MapBlock> blocks;
    for (const SequenceBlock& block : updates.steps[i].changed) blocks.push_back({block.id, block.mesh});
    for (const SequenceBlockId& id : updates.steps[i].removed) blocks.push_back({id, nothing});
    const double before = sums.encode + sums.decode + sums.join;
    add_seconds(sums.encode, [&] { check_or_exit(sender.update(blocks)); });
    exchange();
    add_seconds(sums.join, [&] { join_changed(receiver); });
    sums.largest_update = std::max(sums.largest_update, sums.encode + sums.decode + sums.join - before);
    if (settings.measures)
      sums.largest_error = std::max(sums.largest_error, error_of(receiver, updates.wholes[i]));
  }
  sums.sent = sender.counts().parts_sent;
  sums.kept = sender.counts().kept;
  return sums;
}

}  // namespace deltamesh::bench
