// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/renumber.h"

#include <limits>
#include <utility>

namespace deltamesh::gltf {
namespace {
constexpr std::size_t kDropped = std::numeric_limits<std::size_t>::max();
}

Renumbering renumber(const std::vector<bool>& used, const std::set<std::uint64_t>& pinned) {
  std::vector<std::size_t> old_of_new;
  for (const std::uint64_t element : pinned) {
    if (element >= used.size()) break;
    old_of_new.resize(static_cast<std::size_t>(element) + 1, kDropped);
    old_of_new.back() = static_cast<std::size_t>(element);
  }
  std::size_t free_number = 0;
  for (std::size_t element = 0; element < used.size(); ++element) {
    if (!used[element] || pinned.count(element) != 0) continue;
    while (free_number < old_of_new.size() && old_of_new[free_number] != kDropped) ++free_number;
    if (free_number == old_of_new.size()) old_of_new.push_back(kDropped);
    old_of_new[free_number] = element;
  }
  for (std::size_t element = 0; element < old_of_new.size(); ++element)
    if (old_of_new[element] == kDropped) old_of_new[element] = element;
  std::vector<std::size_t> new_of_old(used.size(), kDropped);
  for (std::size_t i = 0; i < old_of_new.size(); ++i)
    if (new_of_old[old_of_new[i]] == kDropped) new_of_old[old_of_new[i]] = i;
  return {std::move(old_of_new), std::move(new_of_old)};
}

void reorder(Json& list, const Renumbering& numbers) {
  Json reordered = Json::array();
  for (const std::size_t old : numbers.old_of_new) reordered.push_back(list[old]);
  list = std::move(reordered);
}

}  // namespace deltamesh::gltf
