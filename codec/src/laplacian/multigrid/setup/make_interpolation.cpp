// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/make_interpolation.h"

#include <array>
#include <cstdint>

#include "base/threads/thread_team.h"

namespace deltamesh::multigrid {
namespace {

/// What a neighbour that is a seed counts: it knows its aggregate's value better.
constexpr std::uint32_t kSeedCount = 4;

/// Of some nodes of a level.
class Interpolator {
 public:
  Interpolator(const Level& fine, const Aggregates& aggregates)
      : fine_(fine), codes_(aggregates.codes.data()), counts_(aggregates.count(), 0) {}

  Interpolation of(std::uint32_t node) noexcept {
    const std::uint32_t* const first = fine_.neighbors.data() + fine_.offsets[node];
    const std::uint32_t* const end = fine_.neighbors.data() + fine_.offsets[node + 1];
    for (const std::uint32_t* e = first; e != end; ++e) {
      const std::uint32_t code = codes_[*e];
      counts_[code % Aggregates::kSeed] += 1 + code / Aggregates::kSeed * (kSeedCount - 1);
    }
    Keys largest{};
    for (const std::uint32_t* e = first; e != end; ++e) {
      const std::uint32_t aggregate = codes_[*e] % Aggregates::kSeed;
      insert(std::uint64_t{counts_[aggregate]} << 32 | ~aggregate, largest);
      counts_[aggregate] = 0;  // met again, it counts nothing
    }
    return weighted(largest);
  }

 private:
  using Keys = std::array<std::uint64_t, 3>;  ///< falling: a count, then the complement of its aggregate

  /// By masks: compilers make branches of std::min() and std::max(), which could not be predicted.
  static void insert(std::uint64_t key, Keys& largest) noexcept {
    for (std::uint64_t& other : largest) {
      const std::uint64_t if_larger = key > other ? ~std::uint64_t{0} : 0;
      const std::uint64_t change = (key ^ other) & if_larger;
      key ^= change;
      other ^= change;
    }
  }

  static Interpolation weighted(const Keys& largest) noexcept {
    const auto count = [&](std::size_t k) { return static_cast<std::uint32_t>(largest[k] >> 32); };
    const auto node = [&](std::size_t k) { return ~static_cast<std::uint32_t>(largest[k]); };
    const auto sum = static_cast<double>(std::uint64_t{count(0)} + count(1) + count(2));
    // A quotient of such whole numbers is never rounded to the next one.
    const auto sixteenths = [&](std::size_t k) {
      return static_cast<std::uint32_t>((32 * static_cast<double>(count(k)) + sum) / (2 * sum));
    };
    const std::uint32_t second = sixteenths(1);
    const std::uint32_t third = sixteenths(2);
    return {{node(0), second > 0 ? node(1) : node(0), third > 0 ? node(2) : node(0)}, second, third};
  }

  const Level& fine_;
  const std::uint32_t* codes_;
  LargeVector<std::uint32_t> counts_;  ///< by aggregate; 0 between nodes
};

}  // namespace

LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates,
                                              ThreadTeam* team) {
  LargeVector<Interpolation> result(fine.node_count());
  share_rows(team, result.size(), [&](std::uint32_t begin, std::uint32_t end) {
    Interpolator interpolator(fine, aggregates);
    for (std::uint32_t node = begin; node < end; ++node) {
      const std::uint32_t code = aggregates.codes[node];
      const bool is_seed = code >= Aggregates::kSeed;
      result[node] = code == Aggregates::kNone ? Interpolation::none()
                     : is_seed                 ? Interpolation(aggregates.of(node))
                                               : interpolator.of(node);
    }
  });
  return result;
}

}  // namespace deltamesh::multigrid
