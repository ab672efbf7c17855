// The ways between two who come too close, around their conflict: how far apart they are at any instant of it,
// exactly as far as the numbers are kept, and not from where bees are drawn.
import { readCounts, readMeasures } from './column';
import type { PairWaysHead } from './page';

export interface ApartNow {
  distance_m: number;
  horizontal_m: number;
  height_m: number;
  /** How fast the distance shrinks, and how fast either moves beside the other. */
  closing_mps: number;
  relative_mps: number;
}

/** Instants that are told in ticks may be off by so much. */
const kRounding_s = 1e-6;

type Axes = readonly [Float64Array, Float64Array, Float64Array];

export class PairWays {
  readonly #from: Uint32Array;

  constructor(
    counts: Uint32Array,
    readonly time_s: Float64Array,
    readonly straight: Axes,
    /** Over the ground, and the heights: where up is no axis. */
    readonly ground: Axes | null,
    readonly height: Float64Array | null,
    /** Whether heights count by themselves: the straight line is then that over the ground and up. */
    readonly heightsApart: boolean,
  ) {
    this.#from = new Uint32Array(counts.length + 1);
    for (let place = 0; place < counts.length; ++place) this.#from[place + 1] = this.#from[place] + counts[place];
  }

  /** From when to when the way at this place is known; null where none is kept. */
  span(place: number): [number, number] | null {
    const [from, end] = [this.#from[place], this.#from[place + 1]];
    if (end === undefined || end === from) return null;
    return [this.time_s[from], this.time_s[end - 1]];
  }

  /** Whether an instant lies within that, but for a rounding. */
  covers(place: number, time_s: number): boolean {
    const span = this.span(place);
    return span !== null && time_s >= span[0] - kRounding_s && time_s <= span[1] + kRounding_s;
  }

  at(place: number, asked_s: number): ApartNow | null {
    const span = this.span(place);
    if (!span || !this.covers(place, asked_s)) return null;
    const time_s = Math.min(span[1], Math.max(span[0], asked_s));
    let low = this.#from[place];
    let high = this.#from[place + 1] - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time_s[middle] <= time_s) low = middle;
      else high = middle;
    }
    const lasts_s = this.time_s[high] - this.time_s[low];
    const share = lasts_s > 0 ? (time_s - this.time_s[low]) / lasts_s : 0;
    const along = (axis: Float64Array): number => axis[low] + share * (axis[high] - axis[low]);
    const axes = this.heightsApart && this.ground && this.height ? [...this.ground, this.height] : this.straight;
    const way = axes.map(along);
    const distance_m = Math.hypot(...way);
    const [x, y, z] = (this.ground ?? this.straight).map(along);
    const speeds = axes.map((axis) => (lasts_s > 0 ? (axis[high] - axis[low]) / lasts_s : 0));
    const outward = way.reduce((sum, metres, axis) => sum + metres * speeds[axis], 0);
    return {
      distance_m,
      horizontal_m: this.height ? Math.hypot(x, y, z) : Math.hypot(x, y),
      height_m: Math.abs(this.height ? along(this.height) : z),
      closing_mps: distance_m > 0 ? -outward / distance_m : 0,
      relative_mps: Math.hypot(...speeds),
    };
  }

  /** The instants at which one of them turns, and enough in between to draw a curve by. */
  instants(place: number, wanted: number): number[] {
    const span = this.span(place);
    if (!span) return [];
    const [begins_s, ends_s] = span;
    const even = Array.from({ length: wanted + 1 }, (_, i) => begins_s + (i / wanted) * (ends_s - begins_s));
    const turns = this.time_s.subarray(this.#from[place], this.#from[place + 1]);
    return Array.from(new Set([...even, ...turns])).sort((a, b) => a - b);
  }
}

export async function readPairWays(head: PairWaysHead, heightsApart: boolean): Promise<PairWays> {
  const axes = async (x: keyof PairWaysHead, y: keyof PairWaysHead, z: keyof PairWaysHead): Promise<Axes | null> => {
    const [a, b, c] = [head[x], head[y], head[z]];
    return a && b && c ? [await readMeasures(a), await readMeasures(b), await readMeasures(c)] : null;
  };
  const straight = await axes('x', 'y', 'z');
  if (!straight) throw new Error('the ways between pairs lack an axis');
  return new PairWays(
    await readCounts(head.counts),
    await readMeasures(head.time_s),
    straight,
    await axes('ground_x', 'ground_y', 'ground_z'),
    head.height ? await readMeasures(head.height) : null,
    heightsApart,
  );
}
