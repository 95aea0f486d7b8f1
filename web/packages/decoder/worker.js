// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A worker of a DecoderPool: streams come one at a time; modules come from the page, compiled, when they are asked for.
import { Decoder, noModule } from './decode.js';
import { DeltameshError, plainError } from './errors.js';
import { listen, post } from './port.js';

const asked = new Map();
let decoder;
/** Of the options that the decoder has: where they change, its memory goes. */
let current;

function askFor(name) {
  return new Promise((resolve, reject) => {
    asked.set(name, { resolve, reject });
    post({ need: name });
  });
}

function answer({ name, module, failure }) {
  const { resolve, reject } = asked.get(name);
  if (module) resolve(module);
  else reject(new Error(failure));
}

async function decode({ key, maxMemory, bytes, limits }) {
  if (key !== current) [decoder, current] = [new Decoder(askFor, maxMemory), key];
  try {
    await decoder.load('core');
  } catch (error) {
    return noModule('core', error);
  }
  return bytes ? decoder.decode(bytes, { limits }) : null;
}

listen(async (message) => {
  if (message.name) return answer(message);
  const result = await decode(message);
  if (result instanceof DeltameshError) return post({ error: plainError(result) });
  const arrays = result ? [result.positions, result.indices, result.groups, ...result.attributes.map(({ values }) => values)] : [];
  post({ mesh: result }, arrays.filter(Boolean).map(({ buffer }) => buffer));
});
