// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Links in trouble, clocks that jump, viewers that come and go, limits: at no moment a crack, and whatever is
// older than five round trips and its bytes at the rate is shown. DELTAMESH_MAP_TROUBLES: how many schedules;
// DELTAMESH_MAP_FIRST_TROUBLE: the number of the first.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/live/shown_squares.h"
#include "map/live/trouble_link.h"
#include "map/map_world.h"
#include "part/view_cells.h"

namespace deltamesh::map_trouble_test {
namespace {

using test::Square;
using test::TroubleLink;
using test::World;
using Direction = TroubleLink::Direction;

constexpr double kTroubled = 100;  // seconds
constexpr double kChanging = 130;
constexpr double kEnd = 150;
constexpr double kUpdateSeconds = 0.4;
constexpr double kBytesPerSquare = 800;  // of a map that comes more than once, as it changes on its way

/// A clock that is set now and then.
struct Clock {
  double offset = 0;
  double at(double now) const { return now + offset; }
};

struct Client {
  Client(double round_trip, double rate, std::uint32_t seed) : link(round_trip / 2, rate, seed) {}

  TroubleLink link;
  std::unique_ptr<MapReceiver> receiver{};
  std::uint64_t viewer = 0;
  bool is_limited = false;
  Clock clock{};
  std::size_t since = 0;  ///< the tick at which its view was set
  test::ShownSquares shown{};
  double link_carried = 0;
  std::vector<double> alive{};    ///< of its link, at each tick
  std::vector<double> carried{};  ///< bytes, likewise, at the view's rate
};

class Schedule {
 public:
  explicit Schedule(std::uint32_t seed) : random_(seed), world_(3 + static_cast<int>(seed % 3), seed) {
    SenderOptions options;
    options.geometry = GeometryCoder::kPredictive;
    options.split.most_triangles = 1U << (random_() % 4);
    if (random_() % 4 == 0) {  // with coarser copies
      options.split.most_level = 1;
      options.split.copy_level = 2;
    }
    options.keeps_good_enough = random_() % 2 == 0;
    auto sender = MapSender::make(World::description(), options);
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    tell(world_.present());
    for (auto count = 1 + random_() % 3; count > 0; --count) {
      constexpr double kRates[] = {8000, 16'000, 32'000};
      constexpr double kRoundTrips[] = {0.02, 0.1, 0.3};
      clients_.emplace_back(kRoundTrips[random_() % 3], kRates[random_() % 3], random_());
    }
    for (Client& client : clients_) start(client);
  }

  void run() {
    for (; now_ < kEnd && !::testing::Test::HasFailure(); ++tick_) {
      now_ = TroubleLink::kTick * static_cast<double>(tick_);
      const bool is_update = tick_ % static_cast<std::size_t>(kUpdateSeconds / TroubleLink::kTick) == 0;
      if (now_ < kChanging && is_update) tell(world_.change());
      if (now_ < kChanging) disturb();
      for (Client& client : clients_) talk(client);
      if (tick_ % 8 == 0)
        for (const Client& client : clients_) expect_alive(client);
    }
  }

 private:
  void tell(const std::set<Square>& squares) {
    ASSERT_TRUE(world_.tell(*sender_, squares));
    history_.add(world_, now_);
  }

  void disturb() {
    if (random_() % 500 == 0) sender_clock_.offset += jump();
    Client& client = clients_[random_() % clients_.size()];
    if (random_() % 300 == 0) client.clock.offset += jump();
    if (random_() % 400 == 0) start(client);
    if (random_() % 300 == 0) set_view(client);
  }

  double jump() {
    constexpr double kSizes[] = {0.2, 3, 100, 10'000};
    return kSizes[random_() % 4] * (random_() % 2 == 0 ? 1 : -1);
  }

  /// The one before is gone without a word.
  void start(Client& client) {
    client.viewer = ++last_viewer_;
    ReceiverLimits limits;
    client.is_limited = random_() % 3 == 0;
    if (client.is_limited) limits.parts = 12;
    client.receiver = std::make_unique<MapReceiver>(client.viewer, World::description().id, limits);
    client.shown = {};
    client.link.cut();
    set_view(client);
  }

  void set_view(Client& client) {
    View view;
    if (client.is_limited || random_() % 2 == 0) {
      const auto x = static_cast<float>(random_() % 4);
      const auto y = static_cast<float>(random_() % 4);
      view.boxes = {{{x + 0.1F, y + 0.1F, -1}, {x + 1.9F, y + 1.9F, 2}}};
    }
    view.max_error = random_() % 2 == 0 ? 0.02F : 0.1F;
    view.bytes_per_second = random_() % 3 == 0 ? 0 : 8000;
    client.receiver->set_view(view);
    client.since = tick_;
  }

  void talk(Client& client) {
    client.link.go_on(now_ < kTroubled);
    for (const auto& message : client.link.take(Direction::kUp))
      (void)sender_->hear(message, sender_clock_.at(now_)).has_value();
    for (const std::uint64_t viewer : sender_->viewers()) {
      if (viewer != client.viewer) continue;
      auto messages = sender_->messages_for(viewer, sender_clock_.at(now_));
      ASSERT_TRUE(messages);
      for (auto& message : *messages) client.link.send(Direction::kDown, std::move(message));
    }
    for (const auto& message : client.link.take(Direction::kDown)) {
      const auto applied = client.receiver->apply(message);
      // Refused is what comes before the map's message, or what is beyond the limits.
      EXPECT_TRUE(applied || applied.error().code == ErrorCode::kInvalidArgument ||
                  applied.error().code == ErrorCode::kLimitExceeded)
          << describe(applied.error());
      const ShownChange change = client.receiver->take_change();
      if (change.changed.empty() && change.removed.empty()) continue;
      client.shown = test::squares_of(*client.receiver);
      EXPECT_EQ(client.shown.wrong, "") << "at " << now_;
    }
    auto said = client.receiver->messages(client.clock.at(now_));
    ASSERT_TRUE(said);
    for (auto& message : *said) client.link.send(Direction::kUp, std::move(message));
    client.alive.push_back(client.link.alive());
    const double asked = client.receiver->view().bytes_per_second;
    const double before = client.carried.empty() ? 0 : client.carried.back();
    const double step = client.link.carried() - client.link_carried;
    client.link_carried = client.link.carried();
    client.carried.push_back(before + (asked > 0 ? std::min(step, asked * TroubleLink::kTick) : step));
  }

  void expect_alive(const Client& client) {
    const View& view = client.receiver->view();
    for (int x = 0; x < world_.edge(); ++x)
      for (int y = 0; y < world_.edge(); ++y) {
        const Square square{x, y, 0};
        if (!is_in_view({0, x, y, 0}, view, World::description())) continue;
        const auto since = history_.outdated_since(square, client.shown, 2 * *view.max_error + 0.02F);
        if (!since) continue;
        const auto tick = std::max(static_cast<std::size_t>(*since / TroubleLink::kTick), client.since);
        const double alive = client.alive.back() - client.alive[tick];
        const double carried = client.carried.back() - client.carried[tick];
        const double trips = 5 * client.link.round_trip();
        const double bytes = kBytesPerSquare * world_.edge() * world_.edge();
        // What is carried in these round trips may be nothing.
        const double rate = carried / std::max(alive, 1e-9);
        if (alive > trips && carried - rate * trips > bytes)
          ADD_FAILURE() << "square " << x << ", " << y << " is of before " << *since << " at " << now_
                        << ": viewer " << client.viewer << ", alive " << alive << " s, carried " << carried
                        << ", queue " << client.link.queued() << " s";
      }
  }

  std::mt19937 random_;
  World world_;
  test::WorldHistory history_;
  std::unique_ptr<MapSender> sender_;
  Clock sender_clock_;
  std::vector<Client> clients_;
  std::uint64_t last_viewer_ = 0;
  std::size_t tick_ = 0;
  double now_ = 0;
};

std::uint32_t number_in(const char* variable, std::uint32_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
}

TEST(MapTrouble, MAP21WhateverIsOlderThanFiveRoundTripsIsShown) {
  const std::uint32_t first = number_in("DELTAMESH_MAP_FIRST_TROUBLE", 0);
  const std::uint32_t count = number_in("DELTAMESH_MAP_TROUBLES", 20);
  for (std::uint32_t i = 0; i < count && !HasFailure(); ++i) {
    SCOPED_TRACE("schedule " + std::to_string(first + i));
    Schedule(first + i).run();
  }
}

}  // namespace
}  // namespace deltamesh::map_trouble_test
