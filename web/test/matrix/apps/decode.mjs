// node, Deno, Bun: here and in a thread.
import { readFileSync } from 'node:fs';

import { createDecoder } from '@deltamesh/decoder';
import { DecoderPool } from '@deltamesh/decoder/pool';

const bytes = readFileSync(new URL('./stream.dmsh', import.meta.url));
const [here, there] = await Promise.all([(await createDecoder()).decode(bytes), new DecoderPool().decode(bytes)]);
console.log(`${here.vertexCount} ${there.vertexCount}`);
