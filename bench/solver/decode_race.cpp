// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "solver/decode_race.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

/// Resident memory of this process, now; 0 where the system does not say.
double resident_megabytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  long size = 0;
  long resident = 0;
  const bool read = std::fscanf(file, "%ld %ld", &size, &resident) == 2;
  std::fclose(file);
  return read ? 1e-6 * static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Peak memory of one decode in a child, above what the child began with.
double peak_megabytes(Peer& peer, const std::vector<std::byte>& bytes) {
  malloc_trim(0);  // else the child would start with what this process has freed
  const double before = resident_megabytes();
  const pid_t child = fork();
  if (child == 0) _exit(peer.decode(bytes) ? 0 : 1);
  rusage usage{};
  int status = 0;
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) return 0;
  return std::max(0.0, 1.024e-3 * static_cast<double>(usage.ru_maxrss) - before);
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
