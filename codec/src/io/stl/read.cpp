// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// STL, ASCII and binary, told apart by size and content: binary files may begin with "solid", too.
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/byte_reader.h"
#include "base/try.h"
#include "io/components.h"
#include "io/first_equal.h"
#include "io/formats.h"
#include "io/polygons/mesh.h"
#include "io/polygons/named_groups.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;  ///< normal, three corners (12 float32), 2 bytes of attributes

struct Facets {
  std::vector<double> coordinates;          ///< 9 for each
  std::vector<std::uint16_t> attributes{};  ///< binary files
  std::string_view header{};                ///< binary files
  NamedGroups groups{};                     ///< text files: by the names of solids
};

/// Facets that a binary header states; 0 where the file is too short for one.
std::uint64_t stated_facets(std::span<const std::byte> bytes) noexcept {
  if (bytes.size() < kHeaderSize) return 0;
  const auto count = ByteReader(bytes.subspan(kHeaderSize)).read<std::uint32_t>();
  return count ? *count : 0;
}

/// Words of an ASCII file, in lower case.
class Words {
 public:
  explicit Words(std::string_view text) : scanner_(text, {}) {}
  std::string_view next() { return lower(scanner_.next_token()); }

  /// A name up to the end of the line, or to where a statement follows it on the same line; as it stands
  /// there, with single spaces.
  std::string next_name() {
    std::string name;
    for (TextScanner before = scanner_;; before = scanner_) {
      const std::string_view as_it_stands = scanner_.next_token_on_line();
      const std::string_view word = lower(as_it_stands);
      if (word.empty()) return name;
      bool statement = word == "solid" || word == "endsolid";
      if (word == "facet") {
        TextScanner ahead = scanner_;
        statement = lower(ahead.next_token()) == "normal";
      }
      if (statement) {
        scanner_ = before;
        return name;
      }
      (name += name.empty() ? "" : " ") += as_it_stands;
    }
  }

  Result<void> expect(std::string_view word, const char* message) {
    if (next() != word) return scanner_.error(message, word_);
    return {};
  }

  TextScanner& scanner() noexcept { return scanner_; }
  Error error(const char* message) const noexcept { return scanner_.error(message, word_); }

 private:
  std::string_view lower(std::string_view word) {
    word_ = word;
    for (char& c : word_)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return word_;
  }

  TextScanner scanner_;
  std::string word_;
};

bool is_binary(std::span<const std::byte> bytes) noexcept {
  if (bytes.size() >= kHeaderSize + 4 && bytes.size() == kHeaderSize + 4 + kFacetSize * stated_facets(bytes))
    return true;
  const std::string_view text = as_text(bytes);
  const std::string word(Words(text).next());
  if (word.empty()) return false;
  return !word.starts_with("solid") || text.substr(0, 1024).find('\0') != text.npos;
}

/// How many facets a binary file has: its size counts more than the number in its header, which some writers
/// leave at 0, at -1, or at what it was before more were added.
Result<std::uint64_t> count_facets(std::span<const std::byte> bytes, ReadReport& report) {
  constexpr std::uint64_t kUnknown = 0xffffffff;
  if (bytes.size() < kHeaderSize + 4)
    return invalid_byte("STL: the file is too short for the number of facets it states", bytes.size());
  const std::uint64_t stated = stated_facets(bytes);
  const std::uint64_t present = (bytes.size() - kHeaderSize - 4) / kFacetSize;
  const std::uint64_t behind = (bytes.size() - kHeaderSize - 4) % kFacetSize;
  if (present < stated && (stated != kUnknown || present == 0))
    return invalid_byte("STL: the file is too short for the number of facets it states", bytes.size());
  if (present != stated && behind != 0)
    return invalid_byte("STL: the file has neither the facets that it states nor whole ones", bytes.size());
  if (present != stated)
    report.leave_out(LeftOutKind::kGuesses, "facets as the file's size tells, not its header", present);
  report.leave_out(LeftOutKind::kElements, "bytes behind the last facet", behind);
  return present;
}

Result<Facets> read_binary(std::span<const std::byte> bytes, ReadReport& report) {
  DELTAMESH_TRY(const std::uint64_t count, count_facets(bytes, report));
  Facets facets{.coordinates = {},
                .attributes = {},
                .header = {reinterpret_cast<const char*>(bytes.data()), kHeaderSize}};
  facets.coordinates.reserve(count * 9);
  facets.attributes.reserve(count);
  for (std::uint64_t f = 0; f < count; ++f) {
    constexpr std::size_t kNormalSize = 12;
    ByteReader facet(bytes.subspan(kHeaderSize + 4 + f * kFacetSize + kNormalSize, kFacetSize - kNormalSize));
    for (int i = 0; i < 9; ++i) {
      DELTAMESH_TRY(const float value, facet.read<float>());
      facets.coordinates.push_back(static_cast<double>(value));
    }
    DELTAMESH_TRY(const auto attribute, facet.read<std::uint16_t>());
    facets.attributes.push_back(attribute);
  }
  return facets;
}

/// The normal is passed over whatever it is: writers put anything there where a facet has no area.
Result<void> read_facet(Words& words, std::vector<double>& coordinates) {
  DELTAMESH_CHECK(words.expect("normal", "STL: 'normal' is missing"));
  for (int k = 0; k < 3; ++k) words.next();
  DELTAMESH_CHECK(words.expect("outer", "STL: 'outer loop' is missing"));
  DELTAMESH_CHECK(words.expect("loop", "STL: 'outer loop' is missing"));
  for (int corner = 0; corner < 3; ++corner) {
    DELTAMESH_CHECK(words.expect("vertex", "STL: 'vertex' is missing"));
    for (int k = 0; k < 3; ++k) {
      DELTAMESH_TRY(const double value, words.scanner().read_number());
      coordinates.push_back(value);
    }
  }
  DELTAMESH_CHECK(words.expect("endloop", "STL: 'endloop' is missing"));
  return words.expect("endfacet", "STL: 'endfacet' is missing");
}

/// One or several solids, by keywords and numbers alone, whatever the lines.
Result<Facets> read_text(std::span<const std::byte> bytes, ReadReport& report) {
  Facets facets;
  Words words(as_text(bytes));
  bool open = false;
  bool any = false;
  for (std::string word(words.next()); !word.empty(); word = words.next()) {
    any = true;
    if (word == "solid" || word == "endsolid") {
      open = word == "solid";
      const std::string name = words.next_name();
      if (open) facets.groups.begin(&GroupName::object, name, report);
    } else if (word == "facet") {
      DELTAMESH_CHECK(read_facet(words, facets.coordinates));
      facets.groups.add_face();
    } else {
      return words.error("STL: neither a facet nor the beginning or end of a solid");
    }
  }
  if (!any) return words.error("STL: the file is empty");
  if (open) report.leave_out(LeftOutKind::kGuesses, "the end of the last solid, for endsolid is missing");
  return facets;
}

/// Colours of facets, 5 bits a component: VisCAM and SolidView set bit 15 where there is one, red highest.
/// Materialise Magics has "COLOR=" and four bytes in the header, clears bit 15 where a facet has its own, red
/// lowest.
void add_colors(const Facets& facets, PolygonMesh& mesh, ReadReport& report) {
  const std::size_t stated = facets.header.find("COLOR=");
  const bool magics = stated != facets.header.npos && stated + 10 <= facets.header.size();
  const auto has_color = [&](std::uint16_t bits) { return ((bits & 0x8000) != 0) != magics; };
  const auto count = static_cast<std::uint64_t>(
      std::count_if(facets.attributes.begin(), facets.attributes.end(), has_color));
  const bool all = !facets.attributes.empty() && (magics || count == facets.attributes.size());
  if (!all) {
    const auto used = std::count_if(facets.attributes.begin(), facets.attributes.end(),
                                    [](auto bits) { return bits != 0; });
    return report.leave_out(LeftOutKind::kFaceValues,
                            count > 0 ? "colours, which not all facets have" : "attribute bytes",
                            static_cast<std::uint64_t>(used));
  }
  Attribute colors =
      make_attribute(AttributeKind::kColor, ComponentType::kU8, 3, "color", facets.attributes.size());
  std::vector<std::uint32_t> owners;
  for (std::size_t f = 0; f < facets.attributes.size(); ++f) {
    const unsigned bits = facets.attributes[f];
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned five = bits >> (magics ? 5 * k : 10 - 5 * k) & 31;
      colors.values[3 * f + k] = has_color(facets.attributes[f])
                                     ? static_cast<std::byte>((five * 255 + 15) / 31)
                                     : static_cast<std::byte>(facets.header[stated + 6 + k]);
    }
    owners.insert(owners.end(), 3, static_cast<std::uint32_t>(f));
  }
  mesh.corner_values.push_back(index_values(std::move(colors), owners));
}

/// One triangle for every three corners. Points are equal where their bits are, but that -0 is 0; they come
/// in the order in which they are first met.
PolygonMesh weld(std::vector<double> coordinates) {
  for (double& x : coordinates) x += 0.0;
  const auto bits_of = [&](std::size_t corner) {
    std::array<std::uint64_t, 3> bits{};
    std::memcpy(bits.data(), &coordinates[3 * corner], sizeof bits);
    return bits;
  };
  const std::vector<std::uint32_t> first = first_equal(coordinates.size() / 3, bits_of);
  PolygonMesh mesh;
  std::vector<std::uint32_t> points(first.size());
  for (std::size_t c = 0; c < first.size(); ++c) {
    const bool is_new = first[c] == c;
    points[c] = is_new ? static_cast<std::uint32_t>(mesh.coordinates.size() / 3) : points[first[c]];
    if (is_new) mesh.coordinates.insert(mesh.coordinates.end(), &coordinates[3 * c], &coordinates[3 * c] + 3);
  }
  for (std::size_t c = 0; c < points.size(); c += 3) mesh.faces.add(std::span(points).subspan(c, 3));
  return mesh;
}

}  // namespace

Result<Imported> read_stl(std::span<const std::byte> bytes) {
  if (bytes.empty()) return invalid_byte("STL: the file is empty", 0);
  ReadReport report;
  DELTAMESH_TRY(Facets facets, is_binary(bytes) ? read_binary(bytes, report) : read_text(bytes, report));
  if (facets.coordinates.size() / 3 > std::numeric_limits<std::uint32_t>::max())
    return invalid_file("STL: more corners than a 32-bit index can name");
  PolygonMesh mesh = weld(std::move(facets.coordinates));
  report.welded_corners = mesh.faces.corners().size() - mesh.coordinates.size() / 3;
  add_colors(facets, mesh, report);
  facets.groups.move_into(mesh, report);
  // The name of the only solid is a title of the file, often the exporter's.
  if (mesh.face_groups.empty()) mesh.group_names.clear();
  return to_triangles(std::move(mesh), std::move(report));
}

}  // namespace deltamesh
