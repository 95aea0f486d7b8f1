// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/compact.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/checked.h"
#include "base/try.h"
#include "document/references.h"
#include "document/renumber.h"

namespace deltamesh::gltf {
namespace {

constexpr std::uint64_t kAlignment = 8;
constexpr Error kBadView{.code = ErrorCode::kInvalidFile,
                         .message = "a reference to a buffer view that does not exist"};
constexpr Error kBadBuffer{.code = ErrorCode::kInvalidFile,
                           .message = "a reference to bytes of a buffer that do not exist"};

/// Whether the object under this key has members of names that its author chose: attributes, morph targets.
bool is_dictionary(std::string_view key) noexcept { return key == "attributes" || key == "targets"; }

/// Views that a member "bufferView" names.
Result<std::vector<bool>> used_views(Json& json) {
  std::vector<bool> used(array_size(json, "bufferViews"));
  Result<void> result;
  for_each_object(json, [&](Json& object, std::string_view key) {
    const Json* view = is_dictionary(key) ? nullptr : find(object, "bufferView");
    if (!view) return;
    const auto number = to_unsigned(*view, kNoLimit, kBadView);
    if (number && *number < used.size())
      used[static_cast<std::size_t>(*number)] = true;
    else
      result = kBadView;
  });
  if (!result) return result.error();
  return used;
}

void renumber_views(Json& json, const Renumbering& numbers) {
  reorder(json["bufferViews"], numbers);
  for_each_object(json, [&](Json& object, std::string_view key) {
    if (is_dictionary(key)) return;
    if (Json* view = find(object, "bufferView")) *view = numbers.new_of_old[view->get<std::size_t>()];
  });
}

/// A run of bytes of one buffer, and where it goes.
struct Run {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::uint64_t target = 0;
};

/// Merges overlapping and touching runs; every run starts at a multiple of the alignment.
void merge_runs(std::vector<Run>& runs) {
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.begin < b.begin; });
  std::vector<Run> merged;
  for (Run run : runs) {
    run.begin = run.begin / kAlignment * kAlignment;
    if (!merged.empty() && run.begin <= merged.back().end)
      merged.back().end = std::max(merged.back().end, run.end);
    else
      merged.push_back(run);
  }
  runs = std::move(merged);
}

/// One object that names bytes of a buffer: a view, or an object of an extension.
struct BufferReference {
  std::size_t buffer = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

bool names_buffer(const Json* member) noexcept { return member && member->is_number_integer(); }

/// Nothing where the object names no buffer. Where it gives no byteLength, the rest of the buffer is meant.
Result<std::optional<BufferReference>> buffer_reference(const Document& document, const Json& object) {
  const Json* number = find(object, "buffer");
  if (!names_buffer(number)) return std::optional<BufferReference>();
  DELTAMESH_TRY(const auto buffer, to_unsigned(*number, kNoLimit, kBadBuffer));
  DELTAMESH_TRY(const auto offset, unsigned_member(object, "byteOffset", 0, kNoLimit, kBadBuffer));
  if (buffer >= document.buffers.size()) return kBadBuffer;
  const Buffer& bytes = document.buffers[static_cast<std::size_t>(buffer)];
  if (!bytes.opaque && offset > bytes.bytes.size()) return kBadBuffer;
  const std::uint64_t rest = bytes.opaque ? 0 : bytes.bytes.size() - offset;
  DELTAMESH_TRY(const auto length, unsigned_member(object, "byteLength", rest, kNoLimit, kBadBuffer));
  if (!bytes.opaque && (length == 0 || length > rest)) return kBadBuffer;
  return std::optional(BufferReference{static_cast<std::size_t>(buffer), offset, length});
}

/// For each buffer the longest one that begins at the same byte in memory, as those that name one file do.
std::vector<std::size_t> longest_of_same(const std::vector<Buffer>& buffers) {
  std::map<const std::byte*, std::size_t> longest;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    std::size_t& best = longest.try_emplace(buffers[i].bytes.data(), i).first->second;
    if (buffers[i].bytes.size() > buffers[best].bytes.size()) best = i;
  }
  std::vector<std::size_t> same(buffers.size());
  for (std::size_t i = 0; i < buffers.size(); ++i) same[i] = longest[buffers[i].bytes.data()];
  return same;
}

/// Runs of every buffer that is not opaque, under the longest of the same.
Result<std::vector<std::vector<Run>>> used_runs(Document& document, const std::vector<std::size_t>& same) {
  std::vector<std::vector<Run>> runs(document.buffers.size());
  Result<void> result;
  for_each_object(document.json, [&](Json& object, std::string_view key) {
    if (!result || is_dictionary(key)) return;
    const auto reference = buffer_reference(document, object);
    if (!reference)
      result = reference.error();
    else if (*reference && !document.buffers[(*reference)->buffer].opaque)
      runs[same[(*reference)->buffer]].push_back(
          {(*reference)->offset, (*reference)->offset + (*reference)->length, 0});
  });
  if (!result) return result.error();
  for (auto& of_buffer : runs) merge_runs(of_buffer);
  return runs;
}

std::vector<std::byte> copy_runs(const Document& document, std::vector<std::vector<Run>>& runs) {
  std::vector<std::byte> merged;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (Run& run : runs[i]) {
      merged.resize((merged.size() + kAlignment - 1) / kAlignment * kAlignment);
      run.target = merged.size();
      const auto bytes = document.buffers[i].bytes.subspan(static_cast<std::size_t>(run.begin),
                                                           static_cast<std::size_t>(run.end - run.begin));
      merged.insert(merged.end(), bytes.begin(), bytes.end());
    }
  }
  return merged;
}

std::uint64_t target_of(const std::vector<Run>& runs, std::uint64_t offset) {
  const auto after = std::upper_bound(runs.begin(), runs.end(), offset,
                                      [](std::uint64_t value, const Run& run) { return value < run.begin; });
  const Run& run = *(after - 1);
  return run.target + (offset - run.begin);
}

void rewrite_references(Document& document, const std::vector<std::vector<Run>>& runs,
                        const std::vector<std::size_t>& same, const std::vector<std::size_t>& new_buffers) {
  for_each_object(document.json, [&](Json& object, std::string_view key) {
    Json* buffer = find(object, "buffer");
    if (is_dictionary(key) || !names_buffer(buffer)) return;
    const auto old_buffer = buffer->get<std::size_t>();
    *buffer = new_buffers[old_buffer];
    if (document.buffers[old_buffer].opaque) return;
    const Json* offset = find(object, "byteOffset");
    const std::uint64_t target = target_of(runs[same[old_buffer]], offset ? offset->get<std::uint64_t>() : 0);
    if (offset || target != 0) object["byteOffset"] = target;
  });
}

/// The JSON of the merged buffer: what the first buffer said of itself, but for its place.
Json merged_buffer_json(const Document& document, std::size_t size) {
  Json json = Json::object();
  for (std::size_t i = 0; i < document.buffers.size() && json.empty(); ++i)
    if (!document.buffers[i].opaque) json = document.json["buffers"][i];
  json.erase("uri");
  json["byteLength"] = size;
  return json;
}

void replace_buffers(Document& document, std::vector<std::byte> merged) {
  std::vector<Buffer> buffers;
  Json json = Json::array();
  if (!merged.empty()) {
    json.push_back(merged_buffer_json(document, merged.size()));
    Buffer& first = buffers.emplace_back();
    first.owned = std::move(merged);
    first.bytes = first.owned;
  }
  for (std::size_t i = 0; i < document.buffers.size(); ++i) {
    if (!document.buffers[i].opaque) continue;
    json.push_back(document.json["buffers"][i]);
    buffers.push_back(std::move(document.buffers[i]));
  }
  document.json["buffers"] = std::move(json);
  document.buffers = std::move(buffers);
}

void drop_if_empty(Json& json, const char* key) {
  const Json* list = find(json, key);
  if (list && list->empty()) json.erase(key);
}

}  // namespace

Result<void> compact_document(Document& document) {
  Json& json = document.json;
  DELTAMESH_TRY(const auto used, used_views(json));
  if (!used.empty()) renumber_views(json, renumber(used, numbers_in_unknown_extensions(json)));
  if (json.contains("buffers")) {
    const auto same = longest_of_same(document.buffers);
    DELTAMESH_TRY(auto runs, used_runs(document, same));
    auto merged = copy_runs(document, runs);
    std::vector<std::size_t> new_buffers(document.buffers.size(), 0);
    std::size_t next = merged.empty() ? 0 : 1;
    for (std::size_t i = 0; i < document.buffers.size(); ++i)
      if (document.buffers[i].opaque) new_buffers[i] = next++;
    rewrite_references(document, runs, same, new_buffers);
    replace_buffers(document, std::move(merged));
  }
  drop_if_empty(json, "bufferViews");
  drop_if_empty(json, "buffers");
  return {};
}

}  // namespace deltamesh::gltf
