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
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "deltamesh/decode.h"
#include "peers/peer.h"
#include "report/table.h"
#include "report/text.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

/// Of both decoders, in turn: the machine is as busy with the one as with the other.
constexpr std::size_t kRounds = 7;
constexpr int kBits = 8;
constexpr double kAnchorShare = 0.005;
/// Bytes of a block that malloc() takes from the system, until the first of them is freed.
constexpr int kUsualThreshold = 128 * 1024;
constexpr int kDracoLevel = 7;
constexpr int kDracoBits = 12;

double system_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_stime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_stime.tv_usec);
}

double wall_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// One figure of every round.
using Rounds = std::vector<double>;

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

/// One that has decoded its stream once; its next decode finds memory as that one left it.
struct Racer {
  std::unique_ptr<Peer> peer;
  std::vector<std::byte> bytes;
  double megabytes = 0;

  bool decode() const { return static_cast<bool>(peer->decode(bytes)); }
};

std::optional<Racer> prepare(std::unique_ptr<Peer> peer, const Mesh& mesh) {
  if (!peer->load(mesh)) return std::nullopt;
  auto bytes = peer->encode();
  if (!bytes) return std::nullopt;
  Racer racer{.peer = std::move(peer), .bytes = *std::move(bytes)};
  racer.megabytes = peak_megabytes(*racer.peer, racer.bytes);
  if (!racer.decode()) return std::nullopt;
  return racer;
}

}  // namespace

void print_decode_race_header() {
  print(table_head({"mesh", "vertices", "ours ns/vertex", "Draco cl 7 qp 12 ns/vertex", "ratio",
                    "of ours the system's", "of Draco's", "ours, two threads, wall ns/vertex",
                    "Draco wall ns/vertex", "ratio", "ours MB", "Draco MB", "ratio"}));
}

void print_decode_race(const std::string& name, const Mesh& mesh) {
  const auto ours = prepare(make_deltamesh_peer(kBits, kAnchorShare), mesh);
  const auto draco = prepare(make_draco_peer(kDracoLevel, kDracoBits), mesh);
  if (!ours || !draco) {
    return print(table_row({name, "does not take part"}));
  }
  const auto decode_by_two = [&] { return decode(ours->bytes, {.threads = 2}).has_value(); };
  bool has_failed = !decode_by_two();
  const auto seconds_of = [&](const auto& clock, const auto& decode) {
    const double start = clock();
    has_failed |= !decode();
    return clock() - start;
  };
  Rounds alone(kRounds), system(kRounds), by_two(kRounds);
  Rounds of_draco(kRounds), system_of_draco(kRounds), wall_of_draco(kRounds);
  for (std::size_t r = 0; r < kRounds; ++r) {
    const auto run_draco = [&] {
      const double before = system_seconds();
      wall_of_draco[r] = seconds_of(wall_seconds, [&] {
        of_draco[r] = seconds_of(processor_seconds, [&] { return draco->decode(); });
        return true;
      });
      system_of_draco[r] = system_seconds() - before;
    };
    const auto run_ours = [&] {
      by_two[r] = seconds_of(wall_seconds, decode_by_two);
      const double before = system_seconds();
      alone[r] = seconds_of(processor_seconds, [&] { return ours->decode(); });
      system[r] = system_seconds() - before;
    };
    if (r % 2 == 0) run_draco();
    run_ours();
    if (r % 2 == 1) run_draco();
  }
  if (has_failed) {
    return print(table_row({name, "does not take part"}));
  }
  const double scale = 1e9 / static_cast<double>(mesh.vertex_count());
  const auto ns = [&](const Rounds& seconds) { return fixed(scale * median(seconds), 0); };
  print(
      table_row({name, number(mesh.vertex_count()), ns(alone), ns(of_draco),
                 fixed(median_ratio(alone, of_draco), 2), ns(system), ns(system_of_draco), ns(by_two),
                 ns(wall_of_draco), fixed(median_ratio(by_two, wall_of_draco), 2), fixed(ours->megabytes, 0),
                 fixed(draco->megabytes, 0), fixed(ours->megabytes / draco->megabytes, 2)}));
}

}  // namespace deltamesh::bench
