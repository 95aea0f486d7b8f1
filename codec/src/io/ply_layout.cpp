// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/ply_layout.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "io/attribute_name.h"
#include "io/components.h"

namespace deltamesh {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 3> kPosition{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kNormal{"nx", "ny", "nz"};
constexpr std::array<std::array<std::string_view, 4>, 3> kColors{
    {{"red", "green", "blue", "alpha"},
     {"r", "g", "b", "a"},
     {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}}};
constexpr std::array<std::array<std::string_view, 2>, 4> kUvs{
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};

class LayoutBuilder {
 public:
  explicit LayoutBuilder(const PlyElement& vertex) : properties_(vertex.properties) {
    layout_.targets.resize(properties_.size());
    claimed_.resize(properties_.size());
    for (std::size_t i = 0; i < properties_.size(); ++i)
      if (!properties_[i].is_list) first_.emplace(properties_[i].name, i);
  }

  PlyVertexLayout build() {
    layout_.has_position = claim(kPosition, PlyTarget::Kind::kPosition);
    if (has_all(kNormal)) add(AttributeKind::kNormal, ComponentType::kF32, kNormal);
    for (const auto& names : kColors) add_color(names);
    for (const auto& names : kUvs)
      if (has_all(names)) add(AttributeKind::kUv, ComponentType::kF32, names);
    for (std::size_t i = 0; i < properties_.size(); ++i) add_generic(i);
    return std::move(layout_);
  }

 private:
  /// The first scalar property of that name, if it is free.
  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = first_.find(name);
    if (found == first_.end() || claimed_[found->second]) return std::nullopt;
    return found->second;
  }

  bool has_all(Names names) const {
    return std::all_of(names.begin(), names.end(), [this](std::string_view name) { return find(name); });
  }

  bool claim(Names names, PlyTarget::Kind kind) {
    if (!has_all(names)) return false;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::size_t i = *find(names[k]);
      claimed_[i] = true;
      layout_.targets[i] = {kind, layout_.attributes.size(), static_cast<std::uint8_t>(k)};
    }
    return true;
  }

  /// Precondition: has_all(names).
  void add(AttributeKind kind, ComponentType type, Names names) {
    claim(names, PlyTarget::Kind::kAttribute);
    layout_.attributes.push_back(
        make_attribute(kind, type, static_cast<std::uint8_t>(names.size()), std::string(names[0]), 0));
  }

  void add_color(const std::array<std::string_view, 4>& names) {
    const Names rgb = Names(names).first(3);
    if (!has_all(rgb)) return;
    const auto type_of = [this](std::string_view name) { return properties_[*find(name)].type; };
    const ComponentType type = type_of(names[0]);
    const bool same = type_of(names[1]) == type && type_of(names[2]) == type;
    const bool integer = type == ComponentType::kU8 || type == ComponentType::kU16;
    const bool real = type == ComponentType::kF32 || type == ComponentType::kF64;
    if (!same || !(integer || real)) return;
    const bool alpha = find(names[3]) && type_of(names[3]) == type;
    add(AttributeKind::kColor, integer ? type : ComponentType::kF32, alpha ? Names(names) : rgb);
  }

  void add_generic(std::size_t i) {
    const PlyProperty& property = properties_[i];
    if (claimed_[i] || property.is_list || find(property.name) != i) return;
    if (!is_attribute_name(property.name)) {
      ++layout_.unnamed;
      return;
    }
    const std::string_view name = property.name;
    add(AttributeKind::kGeneric, property.type, Names(&name, 1));
  }

  const std::vector<PlyProperty>& properties_;
  std::map<std::string_view, std::size_t> first_;  // first scalar property of a name
  std::vector<bool> claimed_;
  PlyVertexLayout layout_;
};

}  // namespace

PlyVertexLayout layout_ply_vertex(const PlyElement& vertex) { return LayoutBuilder(vertex).build(); }

}  // namespace deltamesh
