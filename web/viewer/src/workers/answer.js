// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// How a worker answers a LatestJob.

/**
 * `calls`: name to function of the message, which returns { result, transfer } or a promise of it. Messages without a call that is
 * known are given to `calls.setup`, and not answered.
 */
export function answerCalls(calls) {
  self.onmessage = async ({ data }) => {
    if (!calls[data.call]) return calls.setup(data);
    try {
      const { result, transfer = [] } = await calls[data.call](data);
      self.postMessage({ result }, transfer);
    } catch (error) {
      self.postMessage({ error: error.message });
    }
  };
}
