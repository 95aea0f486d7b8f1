// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Sizes that Draco and meshoptimizer take.
import { dracoPoints } from '../peers/draco.js';
import { meshoptPoints } from '../peers/meshopt.js';
import { answerCalls } from './answer.js';

answerCalls({
  compare: async ({ request }) => ({ result: { draco: await dracoPoints(request), meshopt: await meshoptPoints(request) } }),
});
