// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "solver/decode_race.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>

#include "deltamesh/decode.h"
#include "peers/peer.h"

namespace deltamesh::bench {
namespace {

constexpr int kRuns = 3;
constexpr int kBits = 8;
constexpr double kAnchorShare = 0.005;
/// Bytes of a block that malloc() takes from the system, until the first of them is freed.
constexpr int kUsualThreshold = 128 * 1024;
constexpr int kDracoLevel = 7;
constexpr int kDracoBits = 12;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double system_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_stime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_stime.tv_usec);
}

double wall_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Least of several runs of `decode`, in what `clock` counts; 0 where it fails.
template <class Clock, class Decode>
double least_seconds(const Clock& clock, const Decode& decode) {
  double best = 1e9;
  for (int r = 0; r < kRuns; ++r) {
    const double start = clock();
    if (!decode()) return 0;
    best = std::min(best, clock() - start);
  }
  return best;
}

/// Times are per vertex; those of ours alone are 0 for others.
struct Figures {
  double nanoseconds = 0;       ///< processor time
  double fresh = 0;             ///< likewise, each time with new memory; ours alone
  double system = 0;            ///< what the system takes of `nanoseconds`, on average
  double wall_nanoseconds = 0;  ///< time that passes
  double two_threads = 0;       ///< likewise, decoded by two threads; ours alone
  double megabytes = 0;
};

/// What a process has in memory, without the pages of files, which are those of the program itself: a child
/// begins without most of these and takes them as it comes to them.
struct OwnMemory {
  double now = 0;   ///< MB
  double peak = 0;  ///< likewise; less than that where the program took pages after it
};

/// Zeros where the system does not say.
OwnMemory own_memory() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return {};
  long size = 0;
  long resident = 0;
  long of_files = 0;
  const bool read = std::fscanf(file, "%ld %ld %ld", &size, &resident, &of_files) == 3;
  std::fclose(file);
  if (!read) return {};
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double page = 1e-6 * static_cast<double>(sysconf(_SC_PAGESIZE));
  return {page * static_cast<double>(resident - of_files),
          1.024e-3 * static_cast<double>(usage.ru_maxrss) - page * static_cast<double>(of_files)};
}

/// Peak memory of one decode in a child, above what the child began with. What was freed before makes no
/// difference: large blocks are taken from the system, as by a process that has just begun.
double peak_megabytes(Peer& peer, const std::vector<std::byte>& bytes) {
  malloc_trim(0);  // else the child would start with what this process has freed
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    mallopt(M_MMAP_THRESHOLD, kUsualThreshold);
    const double before = own_memory().now;
    const double grown = peer.decode(bytes) ? own_memory().peak - before : 0;
    _exit(write(ends[1], &grown, sizeof(grown)) == sizeof(grown) ? 0 : 1);
  }
  close(ends[1]);
  double grown = 0;
  if (child < 0 || read(ends[0], &grown, sizeof(grown)) != sizeof(grown)) grown = 0;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return std::max(0.0, grown);
}

Figures run(Peer& peer, const Mesh& mesh, bool is_ours) {
  Figures figures;
  if (!peer.load(mesh)) return figures;
  const auto bytes = peer.encode();
  if (!bytes) return figures;
  figures.megabytes = peak_megabytes(peer, *bytes);
  const auto decode_once = [&] { return static_cast<bool>(peer.decode(*bytes)); };
  const double scale = 1e9 / static_cast<double>(mesh.vertex_count());
  if (!decode_once()) return figures;  // whose memory is new
  const double system_before = system_seconds();
  figures.nanoseconds = scale * least_seconds(processor_seconds, decode_once);
  figures.system = scale * (system_seconds() - system_before) / kRuns;
  figures.wall_nanoseconds = scale * least_seconds(wall_seconds, decode_once);
  if (is_ours) {
    const auto decode_fresh = [&] { return decode(*bytes).has_value(); };
    figures.fresh = scale * least_seconds(processor_seconds, decode_fresh);
    Decoder decoder;
    const auto decode_by_two = [&] { return decoder.decode(*bytes, {.threads = 2}).has_value(); };
    figures.two_threads = scale * least_seconds(wall_seconds, decode_by_two);
  }
  return figures;
}

}  // namespace

void print_decode_race_header() {
  std::printf(
      "| mesh | vertices | ours ns/vertex | with new memory | Draco cl 7 qp 12 ns/vertex | ratio "
      "| of ours the system's | of Draco's | ours, two threads, wall ns/vertex | Draco wall ns/vertex | "
      "ratio "
      "| ours MB | Draco MB | ratio |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_decode_race(const std::string& name, const Mesh& mesh) {
  const Figures ours = run(*make_deltamesh_peer(kBits, kAnchorShare), mesh, true);
  const Figures draco = run(*make_draco_peer(kDracoLevel, kDracoBits), mesh, false);
  std::printf(
      "| %s | %zu | %.0f | %.0f | %.0f | %.2f | %.0f | %.0f | %.0f | %.0f | %.2f | %.0f | %.0f | %.2f |\n",
      name.c_str(), static_cast<std::size_t>(mesh.vertex_count()), ours.nanoseconds, ours.fresh,
      draco.nanoseconds, ours.nanoseconds / draco.nanoseconds, ours.system, draco.system, ours.two_threads,
      draco.wall_nanoseconds, ours.two_threads / draco.wall_nanoseconds, ours.megabytes, draco.megabytes,
      ours.megabytes / draco.megabytes);
  std::fflush(stdout);
}

}  // namespace deltamesh::bench
