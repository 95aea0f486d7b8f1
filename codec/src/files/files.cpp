// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole files: read at once, written to temporaries beside their targets and renamed, so that no half-written
// file remains.
#include "deltamesh/files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/guard.h"

namespace deltamesh {
namespace {

constexpr Error kCannotOpen{.code = ErrorCode::kFileOpen, .message = "cannot open the file for reading"};
constexpr Error kCannotRead{.code = ErrorCode::kFileRead, .message = "reading the file failed"};
constexpr Error kCannotCreate{
    .code = ErrorCode::kFileWrite,
    .message = "cannot create the file; does its folder exist, may you write there?"};
constexpr Error kSameTarget{.code = ErrorCode::kFileWrite, .message = "two of the files to write are one"};
constexpr Error kCannotWrite{.code = ErrorCode::kFileWrite,
                             .message = "writing the file failed; is the disk full?"};

struct FileCloser {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

/// Holds back the signals by which people stop a program, on this thread, while a temporary file exists: it
/// shall not stay behind.
class StopsHeldBack {
 public:
  StopsHeldBack() noexcept {
    sigset_t stops;
    sigemptyset(&stops);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&stops, signal);
    pthread_sigmask(SIG_BLOCK, &stops, &before_);
  }
  ~StopsHeldBack() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  StopsHeldBack(const StopsHeldBack&) = delete;
  StopsHeldBack& operator=(const StopsHeldBack&) = delete;

 private:
  sigset_t before_{};
};

bool write_all(int descriptor, std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return false;
  }
  return true;
}

/// A new file beside `target`, open for writing; `name` becomes its path. Its mode is what the process's
/// umask leaves of `mode`. -1: there is none.
int create_beside(const std::string& target, mode_t mode, std::string& name) {
  constexpr int kTries = 100;
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz012345";
  for (int i = 0; i < kTries; ++i) {
    std::array<std::uint8_t, 6> random{};
    if (getentropy(random.data(), random.size()) != 0) return -1;
    name = target + '.';
    for (const std::uint8_t byte : random) name += kLetters[byte % kLetters.size()];
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/// What a chain of symbolic links leads to, whether or not it exists: links stay, and what they point to is
/// written.
Result<std::string> behind_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the kernel follows
  std::filesystem::path target = path;
  std::error_code failed;
  for (int links = 0; std::filesystem::is_symlink(target, failed); ++links) {
    if (links == kMostLinks) return kCannotCreate;
    const auto next = std::filesystem::read_symlink(target, failed);
    if (failed) return kCannotCreate;
    target = target.parent_path() / next;
  }
  return target.string();
}

Result<void> write_in_place(const std::string& path, std::span<const std::byte> bytes) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return kCannotCreate;
  const bool written = write_all(descriptor, bytes);
  if (close(descriptor) != 0 || !written) return kCannotWrite;
  return {};
}

/// A temporary file beside its target, removed with this object where it has not taken the target's place.
class Temporary {
 public:
  Temporary() = default;
  ~Temporary() {
    if (!path_.empty()) unlink(path_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// The new file has the mode of the one that it replaces, or that of a newly created one. `target`: no
  /// link.
  Result<void> write(const std::string& target, std::span<const std::byte> bytes) {
    target_ = target;
    struct stat before {};
    const bool replaces = stat(target_.c_str(), &before) == 0;
    std::string name;
    const int descriptor = create_beside(target_, replaces ? 0600 : 0666, name);
    if (descriptor < 0) return kCannotCreate;
    path_.swap(name);
    const bool written = write_all(descriptor, bytes) &&
                         (!replaces || fchmod(descriptor, before.st_mode & 07777U) == 0) &&
                         fsync(descriptor) == 0;
    if (close(descriptor) != 0 || !written) return kCannotWrite;
    return {};
  }

  /// Nothing where nothing was written.
  Result<void> take_place() {
    if (!path_.empty() && std::rename(path_.c_str(), target_.c_str()) != 0) return kCannotWrite;
    path_.clear();
    return {};
  }

 private:
  std::string target_;
  std::string path_;  ///< empty: there is no file
};

/// Devices and pipes ("/dev/stdout", "/dev/null") cannot be replaced by a rename: they are written in place.
bool is_replaceable(const std::string& path) noexcept {
  struct stat status {};
  return stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

/// Calls `step(file, number)` for every file until one fails, whose number goes into the error.
template <class Step>
Result<void> for_each_file(std::span<const NewFile> files, Step&& step) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Result<void> done = step(files[i], i);
    if (done) continue;
    Error error = done.error();
    error.where = i;
    return error;
  }
  return {};
}

Result<std::vector<std::byte>> read_whole(const std::string& path) {
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "rb"));
  if (!file) return kCannotOpen;
  std::vector<std::byte> bytes;
  struct stat status {};
  if (fstat(fileno(file.get()), &status) == 0) {
    if (S_ISDIR(status.st_mode))
      return Error{.code = ErrorCode::kFileOpen, .message = "the path is a directory, not a file"};
    if (S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size));
  }
  std::byte block[1 << 16];
  while (const std::size_t got = std::fread(block, 1, sizeof block, file.get()))
    bytes.insert(bytes.end(), block, block + got);
  if (std::ferror(file.get())) return kCannotRead;
  return bytes;
}

Result<void> write_all_or_none(std::span<const NewFile> files) {
  std::vector<std::string> targets(files.size());  // of what is replaced; empty: written in place
  const Result<void> found = for_each_file(files, [&](const NewFile& file, std::size_t i) -> Result<void> {
    if (!is_replaceable(file.path)) return {};
    auto target = behind_links(file.path);
    if (!target) return target.error();
    if (std::ranges::find(targets, *target) != targets.end()) return kSameTarget;
    targets[i] = *std::move(target);
    return {};
  });
  if (!found) return found.error();
  // In place first: while a reader of a pipe keeps us waiting, signals must stop the program.
  const Result<void> in_place = for_each_file(files, [&](const NewFile& file, std::size_t i) {
    return targets[i].empty() ? write_in_place(file.path, file.bytes) : Result<void>();
  });
  if (!in_place) return in_place.error();
  const StopsHeldBack guard;
  std::vector<Temporary> temporaries(files.size());
  const Result<void> written = for_each_file(files, [&](const NewFile& file, std::size_t i) {
    return targets[i].empty() ? Result<void>() : temporaries[i].write(targets[i], file.bytes);
  });
  if (!written) return written.error();
  return for_each_file(files, [&](const NewFile&, std::size_t i) { return temporaries[i].take_place(); });
}

}  // namespace

Result<std::vector<std::byte>> read_file(const std::string& path) noexcept {
  return guarded([&] { return read_whole(path); }, "the file does not fit into memory");
}

Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) noexcept {
  return guarded([&] {
    const NewFile file{path, bytes};
    return write_all_or_none({&file, 1});
  });
}

Result<void> write_files(std::span<const NewFile> files) noexcept {
  return guarded([&] { return write_all_or_none(files); });
}

}  // namespace deltamesh
