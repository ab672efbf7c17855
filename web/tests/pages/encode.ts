// Writes the format of docs/page-format.md, so that the page can be tested by itself.
import { deflateSync } from 'node:zlib';
import type { ColumnPlace } from '../../src/data/column';

type NumberType = Exclude<ColumnPlace['type'], 'json'>;

const kBytes = { u8: 1, u16: 2, u32: 4, f64: 8 } as const;

export function splitPlanes(numbers: ArrayLike<number>, type: NumberType): Uint8Array {
  const width = kBytes[type];
  const count = numbers.length;
  const planes = new Uint8Array(width * count);
  const typed = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, f64: Float64Array }[type].from(numbers);
  const bytes = new Uint8Array(typed.buffer);
  for (let plane = 0; plane < width; ++plane) {
    for (let i = 0; i < count; ++i) planes[plane * count + i] = bytes[width * i + plane];
  }
  return planes;
}

export function differences(numbers: ArrayLike<number>, type: 'u8' | 'u16' | 'u32', code: 'delta' | 'delta2'): Uint32Array {
  const bits = 8 * kBytes[type];
  const signed = (value: number): number => (value << (32 - bits)) >> (32 - bits);
  const out = new Uint32Array(numbers.length);
  let before = 0;
  let slope = 0;
  for (let i = 0; i < numbers.length; ++i) {
    const difference = signed((numbers[i] - before) | 0);
    const d = code === 'delta' ? difference : signed((difference - slope) | 0);
    out[i] = (d << 1) ^ (d >> 31);
    if (bits < 32) out[i] &= 2 ** bits - 1;
    slope = difference;
    before = numbers[i];
  }
  return out;
}

export class Elements {
  readonly #elements: string[] = [];

  numbers(
    type: NumberType,
    numbers: ArrayLike<number>,
    more: { code?: 'delta' | 'delta2'; scale?: number; offset?: number } = {},
  ): ColumnPlace {
    const coded = more.code && type !== 'f64' ? differences(numbers, type, more.code) : numbers;
    return { at: this.#add(splitPlanes(coded, type)), type, count: numbers.length, ...more };
  }

  texts(texts: string[]): ColumnPlace {
    return { at: this.#add(Buffer.from(JSON.stringify(texts), 'utf8')), type: 'json', count: texts.length };
  }

  /** A column of metres as u16. */
  metres(metres: ArrayLike<number>, code?: 'delta' | 'delta2'): ColumnPlace {
    let least = Infinity;
    let most = -Infinity;
    for (let i = 0; i < metres.length; ++i) {
      least = Math.min(least, metres[i]);
      most = Math.max(most, metres[i]);
    }
    if (metres.length === 0) least = most = 0;
    const scale = (most - least) / 65535 || 1;
    const raw = Uint16Array.from(metres, (value) => Math.round((value - least) / scale));
    return this.numbers('u16', raw, { scale, offset: least, ...(code && { code }) });
  }

  /** What takes the place of the line `<!-- beespace: data -->`. */
  html(page: unknown): string {
    const json = JSON.stringify(page).replace(/[<>&]/g, (c) => `\\u00${c.charCodeAt(0).toString(16)}`);
    return [`<script type="application/json" id="beespace-page">${json}</script>`, ...this.#elements].join('\n');
  }

  #add(bytes: Uint8Array): number {
    const at = this.#elements.length;
    const text = deflateSync(bytes, { level: 1 }).toString('base64');
    this.#elements.push(`<script type="text/plain" id="beespace-${at}">${text}</script>`);
    return at;
  }
}
