// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Makes examples, which are seen first: so the build puts all of this worker into one file.
import { buffersOf } from '../mesh/display.js';
import { exampleOf, makeExample } from '../mesh/examples.js';
import { fetchPrepared } from '../mesh/prepared.js';
import { answerCalls } from './answer.js';
import { resultOf, shown } from './result.js';

answerCalls({
  example: async ({ name }) => {
    const stored = fetchPrepared(exampleOf(name));
    const { result, transfer } = shown(makeExample(name));
    const prepared = await resultOf(await stored, result.frame);
    return { result: { ...result, prepared }, transfer: [...transfer, prepared.bytes.buffer, prepared.order.buffer, ...buffersOf(prepared.display)] };
  },
});
