// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stored/map_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "exit_codes.h"
#include "report/console.h"

namespace deltamesh::cli {

std::optional<MapLock> MapLock::take(const std::string& folder, int& status) {
  std::error_code failed;
  const bool is_made = std::filesystem::create_directories(folder, failed);
  MapLock lock(is_made ? folder : "", open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.descriptor_ < 0) {
    print_error(folder, "cannot make the map's folder");
    status = kCannotWrite;
    return std::nullopt;
  }
  // Some file systems have no locks; there nothing keeps two runs apart.
  if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return lock;
  lock.made_.clear();  // it belongs to the other run
  print_error(folder, "another run is changing this map; try again when it has ended");
  status = kCannotWrite;
  return std::nullopt;
}

MapLock::MapLock(std::string made, int descriptor) noexcept
    : made_(std::move(made)), descriptor_(descriptor) {}

MapLock::MapLock(MapLock&& other) noexcept
    : made_(std::move(other.made_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

MapLock::~MapLock() {
  if (descriptor_ < 0) return;
  std::error_code not_empty;
  std::filesystem::remove(made_, not_empty);
  (void)close(descriptor_);
}

}  // namespace deltamesh::cli
