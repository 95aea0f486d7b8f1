// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One run of the program at a time gives a map a new state.
#pragma once

#include <optional>
#include <string>

namespace deltamesh::cli {

/// While this object lives, no other run can lock the folder. Creates the folder, and removes what it created
/// if that is still empty in the end.
class MapLock {
 public:
  /// Nothing, and an error on the terminal, where another run has it or the folder cannot be made.
  static std::optional<MapLock> take(const std::string& folder, int& status);

  MapLock(MapLock&& other) noexcept;
  MapLock& operator=(MapLock&&) = delete;
  ~MapLock();

 private:
  MapLock(std::string made, int descriptor) noexcept;

  std::string made_;  ///< the folder; or empty, where it was there before
  int descriptor_;    ///< of the open folder; -1: none
};

}  // namespace deltamesh::cli
