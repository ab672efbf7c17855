// The coding of columns in docs/page-format.md, the way that `report/` writes them.
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
