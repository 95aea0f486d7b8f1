// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/udp_link.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace deltamesh::bench {
namespace {

constexpr std::size_t kLargestDatagram = 65'507;

void check_socket(bool is_good, const char* what) {
  if (is_good) return;
  std::perror(what);
  std::exit(1);
}

}  // namespace

UdpLink::UdpLink(double loss, std::uint32_t seed) : loss_(loss), random_(seed) {
  from_ = socket(AF_INET, SOCK_DGRAM, 0);
  to_ = socket(AF_INET, SOCK_DGRAM, 0);
  check_socket(from_ >= 0 && to_ >= 0, "socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  check_socket(bind(to_, reinterpret_cast<sockaddr*>(&address), size) == 0, "bind");  // to any free port
  check_socket(getsockname(to_, reinterpret_cast<sockaddr*>(&address), &size) == 0, "getsockname");
  check_socket(connect(from_, reinterpret_cast<const sockaddr*>(&address), size) == 0, "connect");
}

UdpLink::~UdpLink() {
  close(from_);
  close(to_);
}

void UdpLink::send(const std::vector<std::byte>& message, double /*now*/) {
  bytes_ += message.size();
  if (std::uniform_real_distribution<>(0, 1)(random_) < loss_) return;
  (void)::send(from_, message.data(), message.size(), MSG_DONTWAIT);
}

std::vector<std::vector<std::byte>> UdpLink::take(double /*now*/) {
  std::vector<std::vector<std::byte>> messages;
  std::vector<std::byte> datagram(kLargestDatagram);
  for (ssize_t size = 0; (size = recv(to_, datagram.data(), datagram.size(), MSG_DONTWAIT)) >= 0;)
    messages.emplace_back(datagram.begin(), datagram.begin() + size);
  return messages;
}

}  // namespace deltamesh::bench
