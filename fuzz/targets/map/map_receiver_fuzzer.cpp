// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Messages one after another, each after its length in two bytes, given to a receiver and to a sender of a
// small map. What is shown never overlaps, and the receiver's own view is always understood.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "goal.h"
#include "map/map_world.h"

namespace {

using namespace deltamesh;

fuzz::Goal talked("a viewer's message, which the sender answers");
fuzz::Goal was_shown("messages after which a part is shown");

void check_shown(const MapReceiver& receiver) {
  const auto keys = receiver.shown();
  for (const PartKey& a : keys) {
    if (receiver.find(a) == nullptr) std::abort();
    for (const PartKey& b : keys)
      if (a != b && overlap(a, b)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::World world(3, 1);
  auto sender = MapSender::make(test::World::description(), {.effort = 0});
  if (!sender || !world.tell(*sender, world.present())) std::abort();
  MapReceiver receiver(1, test::World::description().id,
                       {.parts = 100, .octets = 1 << 20, .vertices = 1 << 16});
  View view;
  view.max_error = 0.05F;
  receiver.set_view(view);
  fuzz::check(receiver.apply(*write_description(test::World::description())));
  double now = 0;
  auto rest = std::as_bytes(std::span(data, size));
  while (rest.size() >= 2) {
    const std::size_t length = std::to_integer<std::size_t>(rest[0]) | std::to_integer<std::size_t>(rest[1])
                                                                           << 8;
    const auto message = rest.subspan(2, std::min(length, rest.size() - 2));
    rest = rest.subspan(2 + message.size());
    fuzz::check(receiver.apply(message));
    check_shown(receiver);
    const auto heard = sender->hear(message, ++now);
    if (!fuzz::check(heard) || !sender->hear(*receiver.view_message(), now)) continue;
    for (const std::uint64_t viewer : sender->viewers()) {
      const auto messages = sender->messages_for(viewer, now);
      if (messages)
        for (const auto& answer : *messages) fuzz::check(receiver.apply(answer));
    }
    check_shown(receiver);
    talked.reach();
  }
  if (!receiver.shown().empty()) was_shown.reach();
  return 0;
}
