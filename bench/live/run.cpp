// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/run.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "live/shown_state.h"
#include "live/take_step.h"
#include "live/udp_link.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr double kTick = 0.005;
constexpr std::uint64_t kTicksPerSample = 40;
constexpr double kSenderPeriod = 0.05;  // between calls without an occasion
constexpr double kMostIdle = 0.2;       // that the map itself may take from change to change
constexpr double kMostSettling = 60;

/// Links in simulated time.
struct Simulation {
  explicit Simulation(const LiveSettings& settings)
      : down(settings.link, settings.seed), up(settings.link, settings.seed + 1000) {}

  void wait_until(double seconds) noexcept { time = seconds; }
  double now() const noexcept { return time; }

  double time = 0;
  Link down;
  Link up;
};

/// UDP in real time.
struct Loopback {
  explicit Loopback(const LiveSettings& settings)
      : down(settings.link.loss, settings.seed), up(settings.link.loss, settings.seed + 1000) {}

  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  void wait_until(double seconds) const {
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(Seconds(seconds)));
  }
  double now() const { return Seconds(Clock::now() - begin).count(); }

  Clock::time_point begin = Clock::now();
  UdpLink down;
  UdpLink up;
};

/// `Links`: Simulation or Loopback.
template <class Links>
class LiveRun {
 public:
  LiveRun(const MapUpdates& updates, const LiveSettings& settings)
      : updates_(updates),
        settings_(settings),
        sender_(value_or_exit(MapSender::make(map_description(updates, settings.max_error * updates.voxel),
                                              {.message_bytes = settings.message_bytes}))),
        receiver_(1, sender_.description().id, {.message_bytes = settings.message_bytes}),
        links_(settings),
        error_(kFarOff * updates.voxel) {
    View view;
    view.max_error = static_cast<float>(settings.max_error * updates.voxel);
    view.color_error = 4;
    view.bytes_per_second = settings.view_rate;
    receiver_.set_view(view);
  }

  LiveResult run() {
    const auto updates = updates_.steps.size();
    result_.seconds = static_cast<double>(updates) * settings_.seconds_between_updates;
    std::size_t next = 0;
    result_.settled = -1;
    for (std::uint64_t tick = 0;; ++tick) {
      links_.wait_until(kTick * static_cast<double>(tick));
      const double now = links_.now();
      if (now > result_.seconds + kMostSettling) break;
      bool has_occasion = false;
      if (next < updates && now >= static_cast<double>(next) * settings_.seconds_between_updates) {
        take_step(updates_.steps[next++], sender_);
        has_occasion = true;
      }
      for (const auto& message : links_.up.take(now)) {
        check_or_exit(sender_.hear(message, now));
        has_occasion = true;
      }
      if (has_occasion || now - called_ >= kSenderPeriod) send(links_.now());
      receive(links_.now());
      note_idle(now);
      if (tick % kTicksPerSample == 0) sample(now);
      if (now >= result_.seconds && is_settled()) {
        result_.settled = now - result_.seconds;
        break;
      }
    }
    result_.bytes = links_.down.bytes();
    result_.bytes_back = links_.up.bytes();
    return result_;
  }

 private:
  void send(double now) {
    called_ = now;
    if (sender_.viewers().empty()) return;
    for (auto& message : value_or_exit(sender_.messages_for(1, now)))
      links_.down.send(std::move(message), now);
  }

  void receive(double now) {
    for (const auto& message : links_.down.take(now)) (void)receiver_.apply(message).has_value();
    const ShownChange change = receiver_.take_change();
    if ((!change.changed.empty() || !change.removed.empty()) && now <= result_.seconds)
      result_.changes.push_back(now);
    for (auto& message : value_or_exit(receiver_.messages(now))) links_.up.send(std::move(message), now);
  }

  void sample(double now) {
    const ShownAges::Age age = ages_.at(now, sender_, receiver_);
    const double error = settings_.has_errors ? error_.of(sender_, receiver_) / updates_.voxel : 0;
    result_.samples.push_back({now, links_.down.bytes(), age.behind, age.oldest, error});
  }

  void note_idle(double now) {
    const bool is_idle = sender_.hash(1) == receiver_.hash();
    if (is_idle && !is_idle_) result_.idle.emplace_back(now, now);
    if (is_idle) result_.idle.back().second = now;
    is_idle_ = is_idle;
  }

  bool is_settled() const {
    std::vector<PartKey> keys;
    for (const PartEntry& entry : sender_.entries_of(1)) {
      const MapPart* shown = receiver_.find(entry.key);
      if (shown == nullptr) return false;
      keys.push_back(entry.key);
    }
    return keys == receiver_.shown() && keys == sender_.keys() && hashes_are_equal();
  }

  bool hashes_are_equal() const {
    const auto entries = sender_.entries_of(1);
    const auto held = receiver_.held();
    return std::ranges::equal(entries, held, [](const PartEntry& a, const HeldPart& b) {
      return a.key == b.entry.key && a.hash == b.entry.hash;
    });
  }

  const MapUpdates& updates_;
  LiveSettings settings_;
  MapSender sender_;
  MapReceiver receiver_;
  Links links_;
  double called_ = -1;
  ShownAges ages_{};
  ShownError error_;
  bool is_idle_ = false;
  LiveResult result_;
};

}  // namespace

std::vector<double> freezes(const LiveResult& result, const LiveResult& reference) {
  std::vector<double> freezes;
  std::vector<double> ends = result.changes;
  ends.push_back(result.seconds);
  double begin = 0;
  for (const double end : ends) {
    // Where the map itself stands still, nobody waits.
    const auto due = std::ranges::upper_bound(reference.changes, begin);
    const double last_idle =
        due == reference.changes.end() ? end : *due - (due == reference.changes.begin() ? *due : kMostIdle);
    const auto idle =
        std::ranges::upper_bound(result.idle, begin, {}, [](const auto& i) { return i.second; });
    const bool is_idle = idle != result.idle.end() && idle->first <= begin;
    freezes.push_back(std::max(end - std::max({begin, last_idle, is_idle ? idle->second : begin}), 0.0));
    begin = end;
  }
  return freezes;
}

LiveResult run_live(const MapUpdates& updates, const LiveSettings& settings) {
  return LiveRun<Simulation>(updates, settings).run();
}

LiveResult run_live_over_udp(const MapUpdates& updates, const LiveSettings& settings) {
  return LiveRun<Loopback>(updates, settings).run();
}

}  // namespace deltamesh::bench
