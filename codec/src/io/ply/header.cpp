// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/ply/header.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/names.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

std::optional<ComponentType> component_type(std::string_view name) noexcept {
  constexpr std::array<std::string_view, 8> kSizedNames{"int8",  "uint8",  "int16",   "uint16",
                                                        "int32", "uint32", "float32", "float64"};
  for (std::size_t i = 0; i < kPlyTypes.size(); ++i)
    if (name == kPlyTypes[i] || name == kSizedNames[i]) return static_cast<ComponentType>(i);
  return std::nullopt;
}

Result<PlyEncoding> parse_format(TextScanner& line) {
  const std::string_view encoding = line.next_token_on_line();
  if (line.next_token_on_line() != "1.0") return line.error("PLY: only format version 1.0 is known");
  if (encoding == "ascii") return PlyEncoding::kAscii;
  if (encoding == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (encoding == "binary_big_endian") return PlyEncoding::kBigEndian;
  return line.error("PLY: the format is none of ascii, binary_little_endian, binary_big_endian");
}

Result<PlyElement> parse_element(TextScanner& line) {
  const std::string_view name = line.next_token_on_line();
  if (name.empty()) return line.error("PLY: an element without a name");
  DELTAMESH_TRY(const std::uint64_t count, line.read_count(~std::uint64_t{0}));
  return PlyElement{.name = std::string(name), .count = count, .properties = {}};
}

Result<PlyProperty> parse_property(TextScanner& line) {
  PlyProperty property;
  std::string_view type_name = line.next_token_on_line();
  if (type_name == "list") {
    property.is_list = true;
    const auto count_type = component_type(line.next_token_on_line());
    if (!count_type || *count_type == ComponentType::kF32 || *count_type == ComponentType::kF64)
      return line.error("PLY: the length of a list has an unknown type, or is not an integer");
    property.count_type = *count_type;
    type_name = line.next_token_on_line();
  }
  const auto type = component_type(type_name);
  if (!type) return line.error("PLY: a property of unknown type", type_name);
  property.type = *type;
  property.name = line.next_token_on_line();
  if (property.name.empty()) return line.error("PLY: a property without a name");
  return property;
}

/// The header's lines, which end in LF, CR LF or CR. Where the first ends in CR alone all do: the data of a
/// binary file may begin with LF.
class HeaderLines {
 public:
  explicit HeaderLines(std::string_view text) : text_(text) {
    if (text.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
  }

  std::optional<std::string_view> next() noexcept {
    const std::size_t end = text_.find_first_of("\r\n", position_);
    if (end == text_.npos) return std::nullopt;
    const bool pair = text_.substr(end, 2) == "\r\n";
    if (++number_ == 1) lone_returns_ = !pair && text_[end] == '\r';
    const std::string_view line = text_.substr(position_, end - position_);
    position_ = end + (pair && !lone_returns_ ? 2 : 1);
    return line;
  }
  /// Of the last line, from 1.
  std::uint64_t number() const noexcept { return number_; }
  std::size_t position() const noexcept { return position_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::uint64_t number_ = 0;
  bool lone_returns_ = false;
};

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 3> kPosition{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kNormal{"nx", "ny", "nz"};
constexpr std::array<std::array<std::string_view, 4>, 3> kColorNames{
    {{"red", "green", "blue", "alpha"},
     {"r", "g", "b", "a"},
     {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}}};
constexpr std::array<std::array<std::string_view, 2>, 4> kUvNames{
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};

class LayoutBuilder {
 public:
  explicit LayoutBuilder(const PlyElement& element) : properties_(element.properties) {
    layout_.targets.resize(properties_.size());
    claimed_.resize(properties_.size());
    for (std::size_t i = 0; i < properties_.size(); ++i)
      if (!properties_[i].is_list) first_.emplace(properties_[i].name, i);
  }

  PlyLayout build() {
    layout_.has_position = claim(kPosition, PlyTarget::Kind::kPosition);
    if (has_all(kNormal)) add(AttributeKind::kNormal, ComponentType::kF32, kNormal);
    for (const auto& names : kColorNames) add_color(names);
    for (const auto& names : kUvNames)
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
    if (claimed_[i] || property.is_list || find(property.name) != i || !is_attribute_name(property.name))
      return;
    const std::string_view name = property.name;
    add(AttributeKind::kGeneric, property.type, Names(&name, 1));
  }

  const std::vector<PlyProperty>& properties_;
  std::map<std::string_view, std::size_t> first_;  // first scalar property of a name
  std::vector<bool> claimed_;
  PlyLayout layout_;
};

}  // namespace

Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes) {
  constexpr const char* kGoesOn = "PLY: a line of the header goes on behind its end";
  HeaderLines lines(as_text(bytes));
  PlyHeader header;
  bool has_format = false;
  while (const auto text = lines.next()) {
    TextScanner line(*text, {}, lines.number());
    const std::string_view keyword = line.next_token_on_line();
    if (lines.number() == 1) {
      if (keyword != "ply") return line.error("PLY: the file does not begin with 'ply'");
    } else if (keyword == "format") {
      DELTAMESH_TRY(header.encoding, parse_format(line));
      has_format = true;
    } else if (keyword == "element") {
      DELTAMESH_TRY(PlyElement element, parse_element(line));
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) return line.error("PLY: a property before the first element");
      DELTAMESH_TRY(PlyProperty property, parse_property(line));
      header.elements.back().properties.push_back(std::move(property));
    } else if (keyword == "end_header") {
      DELTAMESH_CHECK(line.end_line(kGoesOn));
      if (!has_format) return line.error("PLY: the header states no format");
      header.data_offset = lines.position();
      header.data_line = lines.number() + 1;
      return header;
    } else if (keyword == "comment" || keyword == "obj_info") {
      if (line.next_token_on_line() == "TextureFile") ++header.textures;
      continue;
    } else if (!keyword.empty()) {
      return line.error("PLY: an unknown word in the header", keyword);
    }
    DELTAMESH_CHECK(line.end_line(kGoesOn));
  }
  return invalid_line("PLY: the file ends inside its header", lines.number() + 1);
}

PlyLayout layout_ply_element(const PlyElement& element) { return LayoutBuilder(element).build(); }

}  // namespace deltamesh
