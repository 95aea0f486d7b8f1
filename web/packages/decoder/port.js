// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A worker's end of its messages, in browsers and in node.
import { threads } from './node.js';

const port = () => threads()?.parentPort;

export function listen(onMessage) {
  if (port()) port().on('message', onMessage);
  else self.onmessage = ({ data }) => onMessage(data);
}

export function post(message, transfer = []) {
  (port() ?? self).postMessage(message, transfer);
}
