// Coasts and borders of the Earth, which pages of wide areas hold; web/ground.mjs packs them.
import { bytesOfBase64 } from './base64';
import { mapped } from './earth';
import { inflate } from './inflate';
import type { Origin } from './page';
import type { Box } from './positions';

/** Ends of straight pieces on the page's map, two by two: east and north. */
export interface Ground {
  coasts: number[];
  borders: number[];
}

const kPerDegree = 100;
/** Shown beyond what the bees take: this share of it. */
const kBeyond = 0.15;

class Numbers {
  #at = 0;

  constructor(readonly bytes: Uint8Array) {}

  get isAtEnd(): boolean {
    return this.#at >= this.bytes.length;
  }

  next(): number {
    let zigzag = 0;
    for (let shift = 0; ; shift += 7) {
      if (this.#at >= this.bytes.length || shift > 28) throw new Error('its coasts are damaged');
      const byte = this.bytes[this.#at++];
      zigzag |= (byte & 127) << shift;
      if (byte < 128) break;
    }
    return (zigzag >>> 1) ^ -(zigzag & 1);
  }
}

/** The part of a piece that is within the box; nothing where none is. */
export function clipped([ax, ay, bx, by]: number[], [west, south, east, north]: number[]): number[] {
  let [from, to] = [0, 1];
  for (const [start, way, low, high] of [[ax, bx - ax, west, east], [ay, by - ay, south, north]]) {
    if (way === 0) {
      if (start < low || start > high) return [];
      continue;
    }
    const [one, other] = [(low - start) / way, (high - start) / way];
    from = Math.max(from, Math.min(one, other));
    to = Math.min(to, Math.max(one, other));
  }
  return from < to ? [ax + from * (bx - ax), ay + from * (by - ay), ax + to * (bx - ax), ay + to * (by - ay)] : [];
}

/** All lines of the packed Earth that are around the box, on the map of this origin. */
export function unpackGround(bytes: Uint8Array, origin: Origin, { least, most }: Box): Ground {
  const beyond = kBeyond * Math.max(most[0] - least[0], most[1] - least[1]);
  const room = [least[0] - beyond, least[1] - beyond, most[0] + beyond, most[1] + beyond];
  const ground: Ground = { coasts: [], borders: [] };
  const numbers = new Numbers(bytes);
  let [longitude, latitude] = [0, 0];
  while (!numbers.isAtEnd) {
    const head = numbers.next();
    const into = head & 1 ? ground.borders : ground.coasts;
    let before: number[] | null = null;
    for (let point = 0; point < head >> 1; ++point) {
      longitude += numbers.next();
      latitude += numbers.next();
      const [east, north] = mapped(origin, { longitude_deg: longitude / kPerDegree, latitude_deg: latitude / kPerDegree, height_m: 0 });
      if (before) into.push(...clipped([...before, east, north], room));
      before = [east, north];
    }
  }
  return ground;
}

export async function readGround(origin: Origin, box: Box): Promise<Ground> {
  const holder = document.getElementById('beespace-ground');
  if (!holder) throw new Error('its coasts are missing');
  return unpackGround(await inflate(bytesOfBase64((holder.textContent ?? '').trim())), origin, box);
}
