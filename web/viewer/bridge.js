// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// For maps that are sent by UDP: a datagram is a message of a WebSocket, and the other way round.
import { createSocket } from 'node:dgram';

import { WebSocketServer } from 'ws';

const MOST_DATAGRAM_BYTES = 65507;
const MOST_WAITING_BYTES = 2 ** 20; // more are lost, as on any network, and sent again

/** Pages of other places are not let in. */
const isOwn = ({ origin, req }) => !origin || new URL(origin).host === req.headers.host;

/** WebSockets at /live of an HTTP server, each by a socket of its own to a publisher at `port` of this machine. */
export function bridge(server, port) {
  const sockets = new WebSocketServer({ server, path: '/live', maxPayload: MOST_DATAGRAM_BYTES, verifyClient: isOwn });
  sockets.on('connection', (socket) => {
    const link = createSocket('udp4');
    link.on('error', () => socket.close()); // nobody listens at the port
    link.on('message', (message) => socket.bufferedAmount < MOST_WAITING_BYTES && socket.send(message));
    link.connect(port, '127.0.0.1', () => socket.on('message', (message) => link.send(message)));
    socket.on('error', () => socket.close());
    socket.on('close', () => link.close());
  });
  return sockets;
}
