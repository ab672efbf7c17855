// A zlib stream → what was compressed.
import { inflatePlainly } from './inflate_plainly';

export async function inflate(stream: Uint8Array): Promise<Uint8Array> {
  if (typeof DecompressionStream !== 'function') return inflatePlainly(stream);
  const plain = new Blob([stream as Uint8Array<ArrayBuffer>])
    .stream()
    .pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(plain).arrayBuffer());
}
