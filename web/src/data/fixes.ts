// Where bees are at a time: straight between two fixes, nowhere before, after and in a gap.
import type { Column } from './column';
import type { Positions } from './positions';

const kUnused = new Float32Array(1);

export class Fixes {
  readonly #from: Uint32Array;
  readonly #gapAfter: Uint8Array;
  /** The fix of each bee that was asked for last: time mostly goes on a little. */
  readonly #last: Uint32Array;
  /** Times are rounded to steps of this: so long before it appears and after it is gone a bee is still there. */
  readonly #step_s: number;

  constructor(
    counts: Uint32Array,
    readonly time: Column,
    readonly positions: Positions,
    absentAfter: Uint32Array,
  ) {
    this.#from = new Uint32Array(counts.length + 1);
    for (let bee = 0; bee < counts.length; ++bee) this.#from[bee + 1] = this.#from[bee] + counts[bee];
    this.#last = this.#from.slice(0, counts.length);
    this.#step_s = time.raw instanceof Float64Array ? 0 : time.scale;
    this.#gapAfter = new Uint8Array((time.raw.length + 7) >> 3);
    for (const fix of absentAfter) this.#gapAfter[fix >> 3] |= 1 << (fix & 7);
  }

  get bees(): number {
    return this.#last.length;
  }

  countOf(bee: number): number {
    return this.#from[bee + 1] - this.#from[bee];
  }

  firstOf(bee: number): number {
    return this.#from[bee];
  }

  timeOf(fix: number): number {
    return this.time.offset + this.time.scale * this.time.raw[fix];
  }

  isGapAfter(fix: number): boolean {
    return ((this.#gapAfter[fix >> 3] >> (fix & 7)) & 1) === 1;
  }

  /** Whether the bee was away between two of its fixes. */
  isGapWithin(from: number, to: number): boolean {
    for (let fix = Math.max(0, from); fix < to; ++fix) if (this.isGapAfter(fix)) return true;
    return false;
  }

  /** The last fix of the bee at or before the time; −1 before its first. */
  fixAt(bee: number, time_s: number): number {
    const from = this.#from[bee];
    const end = this.#from[bee + 1];
    if (from === end || time_s < this.timeOf(from)) return -1;
    let low = this.#last[bee];
    if (this.timeOf(low) > time_s) low = from;
    let high = low + 1;
    // Gallop forward from where we were, then halve.
    for (let stride = 1; high < end && this.timeOf(high) <= time_s; stride *= 2) {
      low = high;
      high = Math.min(end, high + stride);
    }
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.timeOf(middle) <= time_s) low = middle;
      else high = middle;
    }
    this.#last[bee] = low;
    return low;
  }

  /** How fast the bee flies at the time, in metres a second along the axes; false: it is not there or stands between no fixes. */
  velocity(bee: number, time_s: number, into: [number, number, number]): boolean {
    const from = this.#from[bee];
    const end = this.#from[bee + 1];
    let fix = Math.max(this.fixAt(bee, time_s), from);
    // At the last fix, and before a gap, as fast as it came.
    if (fix + 1 >= end || this.isGapAfter(fix)) --fix;
    if (fix < from || fix + 1 >= end || this.isGapAfter(fix)) return false;
    const lasts_s = this.timeOf(fix + 1) - this.timeOf(fix);
    if (!(lasts_s > 0)) return false;
    const { x, y, z, step } = this.positions;
    into[0] = (step[0] * (x[fix + 1] - x[fix])) / lasts_s;
    into[1] = (step[1] * (y[fix + 1] - y[fix])) / lasts_s;
    into[2] = (step[2] * (z[fix + 1] - z[fix])) / lasts_s;
    return true;
  }

  #isNow(fix: number, time_s: number): boolean {
    return Math.abs(time_s - this.timeOf(fix)) <= 1.001 * this.#step_s;
  }

  isThere(bee: number, time_s: number): boolean {
    return this.place(bee, time_s, kUnused, kUnused, kUnused, 0);
  }

  /**
   * Puts where the bee is at the time, in the numbers of `positions`, to place `at` of the arrays.
   * False: it is not there.
   */
  place(bee: number, time_s: number, x: Float32Array, y: Float32Array, z: Float32Array, at: number): boolean {
    let fix = Math.max(this.fixAt(bee, time_s), this.#from[bee]);
    const end = this.#from[bee + 1];
    if (fix === end) return false;
    const { positions } = this;
    let share = 0;
    let next = fix;
    if (fix + 1 < end && time_s > this.timeOf(fix) && !this.isGapAfter(fix)) {
      next = fix + 1;
      share = (time_s - this.timeOf(fix)) / (this.timeOf(next) - this.timeOf(fix));
    } else if (!this.#isNow(fix, time_s)) {
      // In a gap, then.
      if (fix + 1 === end || !this.#isNow(fix + 1, time_s)) return false;
      fix = next = fix + 1;
    }
    x[at] = positions.x[fix] + share * (positions.x[next] - positions.x[fix]);
    y[at] = positions.y[fix] + share * (positions.y[next] - positions.y[fix]);
    z[at] = positions.z[fix] + share * (positions.z[next] - positions.z[fix]);
    return true;
  }
}
