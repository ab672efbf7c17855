// A zlib stream → what was compressed.
import { inflatePlainly } from './inflate_plainly';

export async function inflate(stream: Uint8Array): Promise<Uint8Array> {
  if (typeof DecompressionStream !== 'function') return inflatePlainly(stream);
  const through = new DecompressionStream('deflate');
  // Not by way of a Blob: browsers keep these in another process.
  const writer = through.writable.getWriter();
  const written = Promise.all([writer.write(stream as Uint8Array<ArrayBuffer>), writer.close()]);
  const [plain] = await Promise.all([new Response(through.readable).arrayBuffer(), written]);
  return new Uint8Array(plain);
}
