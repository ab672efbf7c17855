// How far the nearest other bee is, in steps of a constant ratio.
import type { SnapshotHead } from './page';
import { readColumn } from './column';

export class Nearest {
  constructor(
    readonly codes: Uint16Array,
    readonly least_m: number,
    readonly ratio: number,
  ) {}

  distance(bee: number): number {
    return this.ofCode(this.codes[bee]);
  }

  ofCode(code: number): number {
    return code === 0 ? 0 : this.least_m * this.ratio ** (code - 1);
  }

  /** How many digits of a distance are surely right. */
  get digits(): number {
    const error = Math.sqrt(this.ratio) - 1;
    return error > 0 ? Math.max(1, Math.min(6, Math.floor(-Math.log10(error)))) : 6;
  }

  /** The code, with a fraction, of a distance. */
  toCode(distance_m: number): number {
    if (distance_m <= 0 || this.ratio <= 1) return 0;
    return Math.max(0, 1 + Math.log(distance_m / this.least_m) / Math.log(this.ratio));
  }

  /** How many bees have each code. */
  countCodes(): Uint32Array {
    const counts = new Uint32Array(65536);
    for (let bee = 0; bee < this.codes.length; ++bee) counts[this.codes[bee]]++;
    return counts;
  }
}

/** The code below which the given share of all bees lies. */
export function quantileCode(counts: Uint32Array, share: number): number {
  let total = 0;
  for (const count of counts) total += count;
  let below = 0;
  for (let code = 0; code < counts.length; ++code) {
    below += counts[code];
    if (below > 0 && below >= share * total) return code;
  }
  return 0;
}

export async function readNearest(head: SnapshotHead): Promise<Nearest | null> {
  if (!head.nearest) return null;
  const { raw } = await readColumn(head.nearest.code);
  const codes = raw instanceof Uint16Array ? raw : Uint16Array.from(raw);
  return new Nearest(codes, head.nearest.least_m, head.nearest.ratio);
}
