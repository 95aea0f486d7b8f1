import { readFile } from 'node:fs/promises';

import { createDecoder } from '@deltamesh/decoder';

export const dynamic = 'force-dynamic';

export default async function Page() {
  const decoder = await createDecoder();
  const { vertexCount } = await decoder.decode(await readFile('public/stream.dmsh'));
  return <p id="count">{vertexCount}</p>;
}
