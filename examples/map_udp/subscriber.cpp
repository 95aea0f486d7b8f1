// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// subscriber PORT SECONDS: shows the map of a publisher on this machine; here it counts triangles.
#include <arpa/inet.h>
#include <deltamesh/map/receiver.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace deltamesh;

static double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main(int argc, char** argv) {
  if (argc != 3) return std::puts("subscriber PORT SECONDS"), 2;
  const int link = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0);
  sockaddr_in publisher{.sin_family = AF_INET, .sin_port = htons(std::atoi(argv[1]))};
  publisher.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(link, reinterpret_cast<sockaddr*>(&publisher), sizeof publisher) != 0)
    return std::perror("connect"), 1;

  MapReceiver receiver(std::random_device{}(), 7);  // another number after each start
  View view;
  view.max_error = 0.01F;  // metres
  view.bytes_per_second = 1'000'000;
  receiver.set_view(view);
  std::vector<std::byte> datagram(65536);
  std::size_t updates = 0;
  for (const double end = now() + std::atof(argv[2]); now() < end; usleep(10'000)) {
    for (ssize_t n; (n = recv(link, datagram.data(), datagram.size(), 0)) >= 0;)
      if (auto done = receiver.apply({datagram.data(), std::size_t(n)}); !done)
        std::fprintf(stderr, "%s\n", describe(done.error()).c_str());
    if (!receiver.take_change().changed.empty()) ++updates;  // draw receiver.find(key)->mesh
    const auto messages = receiver.messages(now());
    if (!messages) return std::puts(describe(messages.error()).c_str()), 1;
    for (const auto& message : *messages) send(link, message.data(), message.size(), 0);
  }
  std::size_t triangles = 0;
  for (const PartKey& key : receiver.shown()) triangles += receiver.find(key)->mesh.triangle_count();
  std::printf("%zu parts, %zu triangles, %zu times changed\n", receiver.shown().size(), triangles, updates);
}
