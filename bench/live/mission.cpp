// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/mission.h"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <random>
#include <utility>
#include <vector>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "live/take_step.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr double kUpdateSeconds = 0.2;
constexpr std::uint32_t kExchanges = 4;  // an update
constexpr double kFinestError = 0.05;    // voxels; of the finest view

double heap_megabytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

class Mission {
 public:
  Mission(const MapUpdates& updates, const MissionSettings& settings)
      : updates_(updates),
        settings_(settings),
        sender_(value_or_exit(MapSender::make(map_description(updates, kFinestError * updates.voxel)))),
        random_(settings.seed) {
    for (std::uint32_t i = 0; i < settings.viewers; ++i) {
      receivers_.emplace_back(i + 1, sender_.description().id);
      receivers_.back().set_view(view_of(i));
    }
  }

  MissionResult run(const std::function<void(const MissionTenth&)>& tell) {
    MissionResult result;
    const double before = heap_megabytes();
    const std::uint32_t count = settings_.updates / static_cast<std::uint32_t>(result.tenths.size());
    std::size_t step = 0;
    for (MissionTenth& tenth : result.tenths) {
      const std::clock_t begin = std::clock();
      const std::uint64_t encoded = sender_.counts().encoded;
      for (std::uint32_t i = 0; i < count; ++i) {
        take_step(updates_.steps[step++ % updates_.steps.size()], sender_);
        for (std::uint32_t k = 0; k < kExchanges; ++k) exchange(settings_.loss);
        tenth.megabytes += (heap_megabytes() - before) / count;
      }
      tenth.milliseconds = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / count;
      tenth.encoded = static_cast<double>(sender_.counts().encoded - encoded) / count;
      tenth.kilobytes = static_cast<double>(std::exchange(bytes_, 0)) / 1e3 / count;
      tell(tenth);
    }
    constexpr int kMostExchanges = 4000;
    for (int i = 0; i < kMostExchanges && !result.has_all; ++i) {
      exchange(0);
      result.has_all = has_all();
    }
    return result;
  }

 private:
  /// Of all, or half of the map; finer or coarser; with a rate or without.
  View view_of(std::uint32_t i) const {
    View view;
    view.max_error = static_cast<float>(kFinestError * updates_.voxel * (1 + i % 5));
    if (i % 3 == 1) {
      const auto half = static_cast<float>(updates_.block_metres * (2 + i));
      view.boxes.push_back({{-half, -half, -half}, {half, half, half}});
    }
    if (i % 2 == 1) view.bytes_per_second = 25'000 * (1 + i);
    return view;
  }

  /// Messages arrive at once or never.
  void exchange(double loss) {
    now_ += kUpdateSeconds / kExchanges;
    const auto arrives = [&] { return std::uniform_real_distribution<>(0, 1)(random_) >= loss; };
    for (std::uint32_t i = 0; i < settings_.viewers; ++i) {
      MapReceiver& receiver = receivers_[i];
      for (const auto& message : value_or_exit(receiver.messages(now_)))
        if (arrives()) check_or_exit(sender_.hear(message, now_));
      const auto heard = sender_.viewers();
      if (!std::ranges::binary_search(heard, std::uint64_t{i} + 1)) continue;
      for (const auto& message : value_or_exit(sender_.messages_for(i + 1, now_))) {
        bytes_ += message.size();
        if (arrives()) (void)receiver.apply(message).has_value();
      }
      (void)receiver.take_change();
    }
  }

  bool has_all() const {
    for (std::uint32_t i = 0; i < settings_.viewers; ++i)
      if (sender_.hash(i + 1) != receivers_[i].hash() || !receivers_[i].lacking().empty() ||
          receivers_[i].shown().empty())
        return false;
    return true;
  }

  const MapUpdates& updates_;
  MissionSettings settings_;
  MapSender sender_;
  std::vector<MapReceiver> receivers_;
  std::mt19937 random_;
  double now_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

MissionResult run_mission(const MapUpdates& updates, const MissionSettings& settings,
                          const std::function<void(const MissionTenth&)>& tell) {
  return Mission(updates, settings).run(tell);
}

}  // namespace deltamesh::bench
