// Columns: lists of numbers or texts, each kept compressed in an element of its own.
// The format is described in docs/page-format.md.
import { bytesOfBase64 } from './base64';
import { inflate } from './inflate';

export type Unsigned = Uint8Array | Uint16Array | Uint32Array;
export type Numbers = Unsigned | Float64Array;

export interface ColumnPlace {
  at: number;
  type: 'u8' | 'u16' | 'u32' | 'f64' | 'json';
  count: number;
  code?: 'delta' | 'delta2';
  scale?: number;
  offset?: number;
}

/** Numbers as they are kept; what is meant is offset + scale × number. */
export interface Column {
  raw: Numbers;
  scale: number;
  offset: number;
}

const kBytes = { u8: 1, u16: 2, u32: 4, f64: 8 } as const;

/** All lowest bytes, then all second ones, ... → numbers. */
export function joinPlanes(bytes: Uint8Array, type: keyof typeof kBytes, count: number): Numbers {
  if (bytes.length !== kBytes[type] * count) {
    throw new Error(`a column of ${count} ${type} holds ${bytes.length} bytes`);
  }
  switch (type) {
    case 'u8':
      return bytes;
    case 'u16': {
      const out = new Uint16Array(count);
      for (let i = 0; i < count; ++i) out[i] = bytes[i] | (bytes[count + i] << 8);
      return out;
    }
    case 'u32': {
      const out = new Uint32Array(count);
      for (let i = 0; i < count; ++i) {
        out[i] =
          bytes[i] |
          (bytes[count + i] << 8) |
          (bytes[2 * count + i] << 16) |
          (bytes[3 * count + i] << 24);
      }
      return out;
    }
    case 'f64': {
      // Every browser's machine is little-endian, as the planes are.
      const out = new Float64Array(count);
      const places = new Uint8Array(out.buffer);
      for (let plane = 0; plane < 8; ++plane) {
        for (let i = 0; i < count; ++i) places[8 * i + plane] = bytes[plane * count + i];
      }
      return out;
    }
  }
}

/** Undoes `delta` and `delta2`, in place; the arrays wrap around as the format asks. */
export function undoDifferences(numbers: Unsigned, code: 'delta' | 'delta2'): void {
  let value = 0;
  let slope = 0;
  const second = code === 'delta2';
  for (let i = 0; i < numbers.length; ++i) {
    const zigzag = numbers[i];
    const difference = (zigzag >>> 1) ^ -(zigzag & 1);
    if (second) slope = (slope + difference) | 0;
    else slope = difference;
    value = (value + slope) | 0;
    numbers[i] = value;
  }
}

export async function readBytes(place: ColumnPlace): Promise<Uint8Array> {
  const holder = document.getElementById(`beespace-${place.at}`);
  if (!holder) throw new Error(`the page lacks its part beespace-${place.at}`);
  return inflate(bytesOfBase64((holder.textContent ?? '').trim()));
}

export async function readColumn(place: ColumnPlace): Promise<Column> {
  if (place.type === 'json') throw new Error('a column of texts where numbers are due');
  const raw = joinPlanes(await readBytes(place), place.type, place.count);
  if (place.code && !(raw instanceof Float64Array)) undoDifferences(raw, place.code);
  return { raw, scale: place.scale ?? 1, offset: place.offset ?? 0 };
}

/** What the numbers of a column mean. */
export async function readMeasures(place: ColumnPlace): Promise<Float64Array> {
  const { raw, scale, offset } = await readColumn(place);
  if (raw instanceof Float64Array && scale === 1 && offset === 0) return raw;
  // Not by Float64Array.from, which takes ten times as long.
  const out = new Float64Array(raw.length);
  for (let i = 0; i < out.length; ++i) out[i] = offset + scale * raw[i];
  return out;
}

/** A column of bees, counts or places in lists. */
export async function readCounts(place: ColumnPlace): Promise<Uint32Array> {
  const { raw } = await readColumn(place);
  return raw instanceof Uint32Array ? raw : Uint32Array.from(raw);
}

export async function readTexts(place: ColumnPlace): Promise<string[]> {
  const texts: unknown = JSON.parse(new TextDecoder().decode(await readBytes(place)));
  if (!Array.isArray(texts) || texts.length !== place.count) throw new Error('a damaged column of texts');
  return texts.map(String);
}
