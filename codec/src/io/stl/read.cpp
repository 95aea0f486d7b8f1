// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// STL, ASCII and binary, told apart by size and content: binary files may begin with "solid", too.
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "base/byte_reader.h"
#include "base/try.h"
#include "io/first_equal.h"
#include "io/formats.h"
#include "io/origin.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;  ///< normal, three corners (12 float32), 2 bytes of attributes

/// Facets that a binary header states; 0 where the file is too short for one.
std::uint64_t stated_facets(std::span<const std::byte> bytes) noexcept {
  if (bytes.size() < kHeaderSize) return 0;
  const auto count = ByteReader(bytes.subspan(kHeaderSize)).read<std::uint32_t>();
  return count ? *count : 0;
}

/// Words of an ASCII file, in lower case.
class Words {
 public:
  explicit Words(std::string_view text) : scanner_(text, false) {}
  std::string_view next() {
    word_ = scanner_.next_token();
    for (char& c : word_)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return word_;
  }
  TextScanner& scanner() noexcept { return scanner_; }

 private:
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

Result<std::vector<double>> read_binary(std::span<const std::byte> bytes) {
  const std::uint64_t facets = stated_facets(bytes);
  if (bytes.size() < kHeaderSize + 4 || (bytes.size() - kHeaderSize - 4) / kFacetSize < facets)
    return invalid_byte("STL: the file is too short for the number of facets it states", bytes.size());
  std::vector<double> coordinates;
  coordinates.reserve(facets * 9);
  for (std::uint64_t f = 0; f < facets; ++f) {
    constexpr std::size_t kNormalSize = 12;
    ByteReader facet(bytes.subspan(kHeaderSize + 4 + f * kFacetSize + kNormalSize, 36));
    for (int i = 0; i < 9; ++i) {
      DELTAMESH_TRY(const float value, facet.read<float>());
      coordinates.push_back(static_cast<double>(value));
    }
  }
  return coordinates;
}

Result<void> read_facet(Words& words, std::vector<double>& coordinates) {
  const auto expect = [&](std::string_view word) { return words.next() == word; };
  if (!expect("normal")) return words.scanner().error("STL: 'normal' is missing");
  words.scanner().skip_line();
  if (!expect("outer") || !expect("loop")) return words.scanner().error("STL: 'outer loop' is missing");
  for (int corner = 0; corner < 3; ++corner) {
    if (!expect("vertex")) return words.scanner().error("STL: 'vertex' is missing");
    for (int k = 0; k < 3; ++k) {
      DELTAMESH_TRY(const double value, words.scanner().read_number());
      coordinates.push_back(value);
    }
  }
  if (!expect("endloop")) return words.scanner().error("STL: 'endloop' is missing");
  if (!expect("endfacet")) return words.scanner().error("STL: 'endfacet' is missing");
  return {};
}

/// One or several solids.
Result<std::vector<double>> read_text(std::span<const std::byte> bytes) {
  std::vector<double> coordinates;
  Words words(as_text(bytes));
  bool open = false;
  for (std::string word(words.next()); !word.empty(); word = words.next()) {
    if (word == (open ? "endsolid" : "solid")) {
      open = !open;
      words.scanner().skip_line();
    } else if (open && word == "facet") {
      DELTAMESH_CHECK(read_facet(words, coordinates));
    } else {
      return words.scanner().error("STL: neither a facet nor the beginning or end of a solid");
    }
  }
  if (open) return words.scanner().error("STL: the file ends inside a solid");
  return coordinates;
}

/// One triangle for every three corners. Points are equal where their bits are, but that -0 is 0; they come
/// in the order in which they are first met.
Imported weld(std::vector<double> coordinates) {
  for (double& x : coordinates) x += 0.0;
  const auto bits_of = [&](std::size_t corner) {
    std::array<std::uint64_t, 3> bits{};
    std::memcpy(bits.data(), &coordinates[3 * corner], sizeof bits);
    return bits;
  };
  const std::vector<std::uint32_t> first = first_equal(coordinates.size() / 3, bits_of);
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  for (std::size_t c = 0; c < first.size(); ++c) {
    const bool is_new = first[c] == c;
    triangles.push_back(is_new ? static_cast<std::uint32_t>(points.size() / 3) : triangles[first[c]]);
    if (is_new) points.insert(points.end(), &coordinates[3 * c], &coordinates[3 * c] + 3);
  }
  Imported imported{.mesh = place_origin(points), .notes = {}};
  imported.notes.welded_corners = triangles.size() - points.size() / 3;
  imported.mesh.triangles = std::move(triangles);
  return imported;
}

}  // namespace

Result<Imported> read_stl(std::span<const std::byte> bytes) {
  if (bytes.empty()) return invalid_byte("STL: the file is empty", 0);
  DELTAMESH_TRY(std::vector<double> coordinates, is_binary(bytes) ? read_binary(bytes) : read_text(bytes));
  if (coordinates.size() / 3 > std::numeric_limits<std::uint32_t>::max())
    return invalid_file("STL: more corners than a 32-bit index can name");
  return weld(std::move(coordinates));
}

}  // namespace deltamesh
