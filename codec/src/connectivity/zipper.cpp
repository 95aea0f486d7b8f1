// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/zipper.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "base/large_vector.h"
#include "base/try.h"
#include "connectivity/refusal.h"
#include "entropy/number_model.h"

namespace deltamesh {
namespace {

Error invalid(const char* message) noexcept { return Refusal{message, "CONN-16"}.error(); }

/// Partners of the second half's boundary edges among those of the first.
class Partners {
 public:
  Partners(const Border& first, const Border& second, std::span<const std::uint32_t> vertex)
      : first_(first), second_(second), vertex_(vertex), partner_(second.item_count(), kNoIndex) {
    for (const std::uint32_t j : first.closed_items()) candidates_.push_back({key(first.edge(j)), j});
    std::sort(candidates_.begin(), candidates_.end());
    is_taken_.resize(candidates_.size(), 0);
    for (const std::uint32_t i : second.closed_items()) partner_[i] = find(second.edge(i));
  }

  /// Of what lies around `item`, as long as it goes on; takes their partners.
  Zip take(std::uint32_t item) {
    std::uint32_t begin = item;
    for (;;) {
      const std::uint32_t before = second_.item(begin).previous;
      if (before == item || partner_[before] == kNoIndex) break;
      if (partner_[before] != first_.item(partner_[begin]).next) break;
      begin = before;
    }
    Zip zip{begin, partner_[begin], 0};
    std::uint32_t partner = zip.partner;
    for (std::uint32_t i = begin; partner_[i] != kNoIndex && partner_[i] == partner;) {
      partner_[i] = kNoIndex;
      i = second_.item(i).next;
      partner = first_.item(partner).previous;
      ++zip.edges;
    }
    return zip;
  }

  bool has(std::uint32_t item) const noexcept { return partner_[item] != kNoIndex; }

 private:
  struct Candidate {
    std::uint64_t key;
    std::uint32_t item;
    friend auto operator<=>(const Candidate&, const Candidate&) = default;
  };

  std::uint64_t key(const DirectedEdge& edge) const noexcept {
    return std::uint64_t{vertex_[edge[0]]} << 32 | vertex_[edge[1]];
  }

  /// Of a candidate that nobody has.
  std::uint32_t find(const DirectedEdge& edge) {
    const std::uint64_t wanted = key({edge[1], edge[0]});
    auto at = std::lower_bound(candidates_.begin(), candidates_.end(), Candidate{wanted, 0});
    for (; at != candidates_.end() && at->key == wanted; ++at) {
      std::uint8_t& is_taken = is_taken_[static_cast<std::size_t>(at - candidates_.begin())];
      if (std::exchange(is_taken, 1) == 0) return at->item;
    }
    return kNoIndex;
  }

  const Border& first_;
  const Border& second_;
  std::span<const std::uint32_t> vertex_;
  LargeVector<std::uint32_t> partner_;  ///< of the second half's items
  std::vector<Candidate> candidates_;   ///< boundary edges of the first half
  std::vector<std::uint8_t> is_taken_;
};

/// Sews zip after zip.
class Zipper {
 public:
  Zipper(Border& first, Border& second) : first_(first), second_(second) {}

  Result<void> close(const Zip& zip) {
    std::uint32_t i = zip.item;
    std::uint32_t j = zip.partner;
    for (std::uint32_t edge = 0; edge < zip.edges; ++edge) {
      if (!second_.is_open(i) || !first_.is_open(j)) return invalid("zip of what is no boundary edge");
      const DirectedEdge own = second_.edge(i);
      const DirectedEdge across = first_.edge(j);
      zipped_.push_back({own[0], across[1]});
      zipped_.push_back({own[1], across[0]});
      second_.sew(i);
      first_.sew(j);
      i = second_.item(i).next;
      j = first_.item(j).previous;
    }
    return {};
  }

  Zipped finish() {
    std::sort(zipped_.begin(), zipped_.end());
    zipped_.erase(std::unique(zipped_.begin(), zipped_.end()), zipped_.end());
    Zipped result;
    for (const ZippedVertex& zipped : zipped_) {
      const bool is_new = result.vertices.empty() || result.vertices.back().vertex != zipped.vertex;
      (is_new ? result.vertices : result.more).push_back(zipped);
    }
    return result;
  }

 private:
  Border& first_;
  Border& second_;
  std::vector<ZippedVertex> zipped_;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class ZipCoder {
 public:
  ZipCoder(Coder& coder, const Border& first, const Border& second)
      : coder_(coder),
        partner_bits_(static_cast<unsigned>(std::bit_width(first.item_count()))),
        item_bits_(static_cast<unsigned>(std::bit_width(second.item_count()))) {}

  std::uint32_t code_count(std::uint32_t zips) { return coder_.number(zips, counts_); }

  Zip code(const Zip& zip) {
    const std::uint32_t item = coder_.bits(zip.item, item_bits_);
    const std::uint32_t partner = coder_.bits(zip.partner, partner_bits_);
    return {item, partner, coder_.number(zip.edges - 1, lengths_) + 1};
  }

 private:
  Coder& coder_;
  unsigned partner_bits_;
  unsigned item_bits_;
  NumberModel counts_;
  NumberModel lengths_;
};

}  // namespace

std::vector<Zip> find_zips(const Border& first, const Border& second, std::span<const std::uint32_t> vertex) {
  std::vector<Zip> zips;
  if (vertex.empty()) return zips;
  Partners partners(first, second, vertex);
  for (const std::uint32_t i : second.closed_items()) {
    if (partners.has(i)) zips.push_back(partners.take(i));
  }
  return zips;
}

Result<Zipped> close_zips(std::span<const Zip> zips, Border& first, Border& second) {
  Zipper zipper(first, second);
  for (const Zip& zip : zips) DELTAMESH_CHECK(zipper.close(zip));
  return zipper.finish();
}

void write_zips(CompactWriter& writer, std::span<const Zip> zips, const Border& first, const Border& second) {
  ZipCoder coder(writer, first, second);
  coder.code_count(static_cast<std::uint32_t>(zips.size()));
  for (const Zip& zip : zips) coder.code(zip);
}

Result<Zipped> read_zips(CompactReader& reader, Border& first, Border& second) {
  ZipCoder coder(reader, first, second);
  Zipper zipper(first, second);
  const std::uint32_t count = coder.code_count(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Zip zip = coder.code({});
    if (reader.failed()) return Zipped{};
    DELTAMESH_CHECK(zipper.close(zip));
  }
  return zipper.finish();
}

Result<void> check_zipped(const Zipped& zipped, std::span<const std::uint32_t> vertex) {
  for (const auto& [own, onto] : zipped.more)
    if (vertex[own] != vertex[onto]) return invalid("manifold vertex zipped onto two vertices");
  return {};
}

}  // namespace deltamesh
