// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Choice of the copy of a geometric vertex that the next corner uses; state shared by the writer and the
// reader of seams [SEAM-4].
#pragma once

#include <cstdint>
#include <optional>

namespace deltamesh {

/// Choices, the ones that a chart of faces around a vertex makes often coming first.
inline constexpr std::uint32_t kSameCopy = 0;   ///< as the corner before at this geometric vertex
inline constexpr std::uint32_t kNewCopy = 1;    ///< one that no corner has used yet
inline constexpr std::uint32_t kOtherCopy = 2;  ///< the one in use before the present one was
inline constexpr std::uint32_t kNamedCopy = 3;  ///< kNamedCopy + c: copy c

/// A geometric vertex with several copies, on the way through the corners in coded order. Its first corner
/// uses copy 0 and makes no choice.
struct SeamVertex {
  std::uint32_t copies = 2;
  std::uint32_t used = 0;
  std::uint32_t present = 0;
  std::uint32_t other = 0;

  std::uint32_t choice_of(std::uint32_t copy) const noexcept {
    if (copy == present) return kSameCopy;
    if (copy == used) return kNewCopy;
    if (copy == other) return kOtherCopy;
    return kNamedCopy + copy;
  }

  /// Nothing when there is no such copy.
  std::optional<std::uint32_t> copy_of(std::uint32_t choice) const noexcept {
    switch (choice) {
      case kSameCopy:
        return present;
      case kNewCopy:
        return used < copies ? std::optional(used) : std::nullopt;
      case kOtherCopy:
        return other;
      default:
        return choice - kNamedCopy < used ? std::optional(choice - kNamedCopy) : std::nullopt;
    }
  }

  void take(std::uint32_t copy) noexcept {
    if (copy == used) ++used;
    if (copy != present) other = present;
    present = copy;
  }
};

}  // namespace deltamesh
