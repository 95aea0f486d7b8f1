// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// How a worker answers a LatestJob, and gets modules from the page.

const NAMES = ['core', 'highpass', 'rare', 'grid', 'zstd', 'encoder'];
const waiting = new Map();

/** Asks the page, which compiles a module once for all workers, and only where one needs it. */
function ask(name) {
  if (!waiting.has(name)) {
    const slot = {};
    slot.module = new Promise((resolve, reject) => Object.assign(slot, { resolve, reject }));
    waiting.set(name, slot);
    self.postMessage({ wanted: name });
  }
  return waiting.get(name).module;
}

/** `files` of decoders and encoders. */
export const modules = Object.fromEntries(NAMES.map((name) => [name, () => ask(name)]));

function takeModule({ name, module, failure }) {
  if (module) waiting.get(name).resolve(module);
  else waiting.get(name).reject(new Error(failure));
  if (!module) waiting.delete(name); // whoever needs it next asks again
}

/**
 * `calls`: name to function of the message, which returns { result, transfer } or a promise of it. Messages without a call that is
 * known are given to `calls.setup`, and not answered.
 */
export function answerCalls(calls) {
  self.onmessage = async ({ data }) => {
    if ('name' in data && !data.call) return takeModule(data);
    if (!calls[data.call]) return calls.setup(data);
    try {
      const { result, transfer = [] } = await calls[data.call](data);
      self.postMessage({ result }, transfer);
    } catch (error) {
      self.postMessage({ error: error.message });
    }
  };
}
