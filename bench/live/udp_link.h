// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One direction of a link over UDP on loopback, with the functions of Link.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace deltamesh::bench {

class UdpLink {
 public:
  /// `loss`: share of messages that are not handed to the socket, as loopback itself loses none. Ends the
  /// program where there is no socket.
  UdpLink(double loss, std::uint32_t seed);
  ~UdpLink();
  UdpLink(const UdpLink&) = delete;
  UdpLink& operator=(const UdpLink&) = delete;

  /// `message`: one datagram. What the socket has no room for is lost.
  void send(const std::vector<std::byte>& message, double now);
  /// What has arrived.
  std::vector<std::vector<std::byte>> take(double now);

  std::uint64_t bytes() const noexcept { return bytes_; }  ///< sent, without headers

 private:
  double loss_;
  std::mt19937 random_;
  int from_ = -1;
  int to_ = -1;
  std::uint64_t bytes_ = 0;
};

}  // namespace deltamesh::bench
