// Inflate (RFC 1950 and 1951) for browsers that do not offer it.
import { adler32 } from './checksum';

const kLengthBase = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];
const kLengthExtra = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const kDistanceBase = [
  1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145,
  8193, 12289, 16385, 24577,
];
const kDistanceExtra = [
  0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13,
];
const kLengthsOrder = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
const kLongestCode = 15;

/** Canonical code: how many codes there are of each length, and the symbols in order of their codes. */
interface Code {
  counts: Uint16Array;
  symbols: Uint16Array;
}

function codeOf(lengths: ArrayLike<number>): Code {
  const counts = new Uint16Array(kLongestCode + 1);
  for (let i = 0; i < lengths.length; ++i) counts[lengths[i]]++;
  counts[0] = 0;
  const from = new Uint16Array(kLongestCode + 2);
  for (let length = 1; length <= kLongestCode; ++length) from[length + 1] = from[length] + counts[length];
  const symbols = new Uint16Array(lengths.length);
  for (let i = 0; i < lengths.length; ++i) if (lengths[i] > 0) symbols[from[lengths[i]]++] = i;
  return { counts, symbols };
}

class Bits {
  #at = 2; // behind the header of zlib
  #held = 0;
  #count = 0;

  constructor(readonly bytes: Uint8Array) {}

  take(count: number): number {
    while (this.#count < count) {
      if (this.#at >= this.bytes.length) throw new Error('a damaged column: it ends early');
      this.#held |= this.bytes[this.#at++] << this.#count;
      this.#count += 8;
    }
    const value = this.#held & ((1 << count) - 1);
    this.#held >>>= count;
    this.#count -= count;
    return value;
  }

  symbol({ counts, symbols }: Code): number {
    let code = 0;
    let first = 0;
    let index = 0;
    for (let length = 1; length <= kLongestCode; ++length) {
      code |= this.take(1);
      const count = counts[length];
      if (code - first < count) return symbols[index + code - first];
      index += count;
      first = (first + count) << 1;
      code <<= 1;
    }
    throw new Error('a damaged column: no such code');
  }

  /** The next whole bytes, of a block that is not compressed. */
  whole(): Uint8Array {
    this.#held = this.#count = 0;
    const length = this.bytes[this.#at] | (this.bytes[this.#at + 1] << 8);
    const part = this.bytes.subarray(this.#at + 4, this.#at + 4 + length);
    this.#at += 4 + length;
    return part;
  }
}

class Output {
  bytes = new Uint8Array(1 << 16);
  length = 0;

  room(more: number): void {
    if (this.length + more <= this.bytes.length) return;
    const larger = new Uint8Array(2 * (this.length + more));
    larger.set(this.bytes);
    this.bytes = larger;
  }

  repeat(distance: number, length: number): void {
    if (distance > this.length) throw new Error('a damaged column: it refers to before its beginning');
    this.room(length);
    for (let i = 0; i < length; ++i, ++this.length) this.bytes[this.length] = this.bytes[this.length - distance];
  }
}

function fixedCodes(): [Code, Code] {
  const lengths = Array.from({ length: 288 }, (_, i) => (i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8));
  return [codeOf(lengths), codeOf(new Array<number>(30).fill(5))];
}

function writtenCodes(bits: Bits): [Code, Code] {
  const literals = bits.take(5) + 257;
  const distances = bits.take(5) + 1;
  const given = bits.take(4) + 4;
  const short = new Uint8Array(19);
  for (let i = 0; i < given; ++i) short[kLengthsOrder[i]] = bits.take(3);
  const code = codeOf(short);
  const lengths: number[] = [];
  while (lengths.length < literals + distances) {
    const symbol = bits.symbol(code);
    if (symbol < 16) lengths.push(symbol);
    else {
      const value = symbol === 16 ? lengths[lengths.length - 1] : 0;
      const times = symbol === 16 ? 3 + bits.take(2) : symbol === 17 ? 3 + bits.take(3) : 11 + bits.take(7);
      for (let i = 0; i < times; ++i) lengths.push(value);
    }
  }
  return [codeOf(lengths.slice(0, literals)), codeOf(lengths.slice(literals, literals + distances))];
}

function compressedBlock(bits: Bits, out: Output, [literals, distances]: [Code, Code]): void {
  for (;;) {
    const symbol = bits.symbol(literals);
    if (symbol === 256) return;
    if (symbol < 256) {
      out.room(1);
      out.bytes[out.length++] = symbol;
      continue;
    }
    const length = kLengthBase[symbol - 257] + bits.take(kLengthExtra[symbol - 257]);
    const place = bits.symbol(distances);
    out.repeat(kDistanceBase[place] + bits.take(kDistanceExtra[place]), length);
  }
}

export function inflatePlainly(stream: Uint8Array): Uint8Array {
  const bits = new Bits(stream);
  const out = new Output();
  let last = false;
  while (!last) {
    last = bits.take(1) === 1;
    const kind = bits.take(2);
    if (kind === 0) {
      const part = bits.whole();
      out.room(part.length);
      out.bytes.set(part, out.length);
      out.length += part.length;
    } else if (kind === 3) {
      throw new Error('a damaged column: no such block');
    } else {
      compressedBlock(bits, out, kind === 1 ? fixedCodes() : writtenCodes(bits));
    }
  }
  const bytes = out.bytes.subarray(0, out.length);
  const told = stream.subarray(stream.length - 4).reduce((sum, byte) => sum * 256 + byte, 0);
  if (told !== adler32(bytes)) throw new Error('a damaged column: its checksum is another');
  return bytes;
}
