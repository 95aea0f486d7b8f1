// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// publisher PORT SECONDS: a map that changes, for everyone who asks for it by UDP. Prints its port.
#include <arpa/inet.h>
#include <deltamesh/map/messages.h>
#include <deltamesh/map/sender.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>

using namespace deltamesh;

static double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a mapper gives: the mesh of a block of 2 m, here of moving waves. Blocks have the vertices on their
/// common border with the same bits.
static Mesh block_mesh(int x, int y, double time) {
  constexpr int kSide = 16;
  Mesh mesh;
  mesh.attributes.push_back({AttributeKind::kColor, ComponentType::kU8, 3, true, "color"});
  for (int i = 0; i <= kSide; ++i)
    for (int j = 0; j <= kSide; ++j) {
      const double u = 2 * x + 2.0 * i / kSide, v = 2 * y + 2.0 * j / kSide;
      const double z = 1 + 0.2 * std::sin(3 * u + 2 * time) * std::cos(2 * v);
      mesh.positions.insert(mesh.positions.end(), {float(u), float(v), float(z)});
      const int high = std::lround(255 * (z - 0.8) / 0.4);  // blue below, orange above
      for (const int c : {high, 120 + high / 4, 255 - high})
        mesh.attributes[0].values.push_back(std::byte(c));
      if (i == kSide || j == kSide) continue;
      const std::uint32_t a = i * (kSide + 1) + j, b = a + kSide + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  return mesh;
}

int main(int argc, char** argv) {
  if (argc != 3) return std::puts("publisher PORT SECONDS"), 2;
  const int link = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0);
  sockaddr_in own{.sin_family = AF_INET, .sin_port = htons(std::atoi(argv[1]))};
  own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof own;
  if (bind(link, reinterpret_cast<sockaddr*>(&own), size) != 0) return std::perror("bind"), 1;
  getsockname(link, reinterpret_cast<sockaddr*>(&own), &size);
  std::printf("%d\n", ntohs(own.sin_port)), std::fflush(stdout);

  MapDescription description{.id = 7, .epoch = 1, .frame = "map"};
  description.lattice.step_exponent = step_exponent_for(0.005);  // metres: the finest error that views get
  description.cell_steps = std::lround(2 / description.lattice.step());  // blocks of 2 m
  description.attributes.push_back({AttributeKind::kColor, ComponentType::kU8, 3, true, "color"});
  auto sender = MapSender::make(description, {.split = {.most_triangles = 2000}});
  if (!sender) return std::puts(describe(sender.error()).c_str()), 1;
  sender->resume(std::uint64_t(std::time(nullptr)) << 10, 0);  // above all revisions before a restart

  std::map<std::uint64_t, sockaddr_in> addresses;  // of viewers
  std::vector<std::byte> datagram(65536);
  const double begin = now(), end = begin + std::atof(argv[2]);
  double next = begin;
  while (now() < end) {
    const double time = now();
    if (time >= next && time < (begin + end) / 2) {  // five updates a second, in the first half
      next += 0.2;
      std::vector<Mesh> meshes;
      std::vector<MapBlock> blocks;
      for (int i = 0; i < 64; ++i) meshes.push_back(block_mesh(i / 8, i % 8, time - begin));
      for (int i = 0; i < 64; ++i) blocks.push_back({{i / 8, i % 8, 0}, meshes[i]});
      if (auto done = sender->update(blocks); !done) return std::puts(describe(done.error()).c_str()), 1;
    }
    sockaddr_in from{};
    for (ssize_t n; size = sizeof from, (n = recvfrom(link, datagram.data(), datagram.size(), 0,
                                                      reinterpret_cast<sockaddr*>(&from), &size)) >= 0;) {
      const std::span message(datagram.data(), n);
      if (const auto heard = sender->hear(message, time); !heard)
        std::fprintf(stderr, "%s\n", describe(heard.error()).c_str());
      if (const auto view = read_view(message)) addresses[view->viewer] = from;
    }
    for (const std::uint64_t viewer : sender->viewers()) {
      const auto messages = sender->messages_for(viewer, time);
      if (!messages) {  // of what this viewer said: the others get theirs
        std::fprintf(stderr, "%s\n", describe(messages.error()).c_str());
        sender->forget(viewer);
        continue;
      }
      for (const auto& message : *messages)
        sendto(link, message.data(), message.size(), 0, reinterpret_cast<sockaddr*>(&addresses[viewer]),
               sizeof from);
    }
    usleep(10'000);
  }
}
