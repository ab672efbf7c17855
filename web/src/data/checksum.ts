// Adler-32 (RFC 1950), as zlib streams have it.

export function adler32(bytes: Uint8Array): number {
  let a = 1;
  let b = 0;
  // So many bytes that sums stay whole numbers without a remainder at each.
  const kStride = 3800;
  for (let from = 0; from < bytes.length; from += kStride) {
    const end = Math.min(bytes.length, from + kStride);
    for (let i = from; i < end; ++i) {
      a += bytes[i];
      b += a;
    }
    a %= 65521;
    b %= 65521;
  }
  return b * 65536 + a;
}
