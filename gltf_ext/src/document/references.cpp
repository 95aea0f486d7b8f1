// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/references.h"

#include <vector>

#include "base/try.h"

namespace deltamesh::gltf {
namespace {

Result<void> check_samplers(const Json& json) {
  const Json* animations = find(json, "animations");
  for (std::size_t i = 0; animations && i < animations->size(); ++i) {
    const Error bad = element_error("an animation whose samplers are not objects", i);
    DELTAMESH_CHECK(check_array_of_objects((*animations)[i], "samplers", bad));
  }
  return {};
}

void collect(const Json& root, std::set<std::uint64_t>& numbers) {
  std::vector<const Json*> pending{&root};
  while (!pending.empty()) {
    const Json& value = *pending.back();
    pending.pop_back();
    if (value.is_number_integer() && (value.is_number_unsigned() || value.get<std::int64_t>() >= 0))
      numbers.insert(value.get<std::uint64_t>());
    if (!value.is_structured()) continue;
    for (auto item = value.begin(); item != value.end(); ++item) {
      const bool known = value.is_object() && (item.key() == "bufferView" || item.key() == "extras");
      if (!known) pending.push_back(&*item);
    }
  }
}

}  // namespace

std::set<std::uint64_t> numbers_in_unknown_extensions(const Json& json) {
  std::set<std::uint64_t> numbers;
  for_each_object(json, [&](const Json& object, std::string_view) {
    const Json* extensions = find(object, "extensions");
    if (!extensions || !extensions->is_object()) return;
    for (auto item = extensions->begin(); item != extensions->end(); ++item)
      if (!is_harmless_extension(item.key())) collect(*item, numbers);
  });
  return numbers;
}

Result<void> check_other_accessors(const Json& json) {
  for (const char* key : {"skins", "animations"})
    DELTAMESH_CHECK(check_array_of_objects(
        json, key, {.code = ErrorCode::kInvalidFile, .message = "skins or animations are not objects"}));
  DELTAMESH_CHECK(check_samplers(json));
  const std::size_t accessors = array_size(json, "accessors");
  const Error bad{.code = ErrorCode::kInvalidFile, .message = "a skin or an animation names no accessor"};
  Result<void> result;
  for_each_other_accessor(json, [&](const Json& value) {
    const auto number = to_unsigned(value, kNoLimit, bad);
    if (!number || *number >= accessors) result = bad;
  });
  return result;
}

}  // namespace deltamesh::gltf
