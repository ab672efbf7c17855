// How a bee of a recording flew: how high it was at each fix, and how fast it went along the ground and up between them. From
// the positions as they are shown: what the engine has decided about limits is not decided here.
import type { Recording } from './recording';
import { speedsOf } from './speeds';

export interface Flown {
  /** Of each fix. */
  fix_s: Float64Array;
  height_m: Float64Array;
  /** Whether the bee is nowhere from this fix to the next one. */
  gapAfter: Uint8Array;
  /** Stretches without a gap, one from each fix on; of long ones the middles follow one another. */
  from_s: Float64Array;
  to_s: Float64Array;
  horizontal_mps: Float64Array;
  climb_mps: Float64Array;
  /** Stretches are at least so long, as far as there are fixes: speeds are means. */
  over_s: number;
}

/** Positions are rounded: stretches are so long that this changes a speed that is usual here by no more than so much of it. */
const kShare = 0.02;

function stretchFor({ fixes }: Recording): number {
  const { usual_mps } = speedsOf(fixes);
  const rounding_m = Math.hypot(...fixes.positions.step);
  return usual_mps > 0 ? rounding_m / (kShare * usual_mps) : 0;
}

const kStretches = new WeakMap<Recording, number>();

export function flownBy(swarm: Recording, bee: number): Flown {
  const { fixes } = swarm;
  const { x, y, z, start, step } = fixes.positions;
  const over_s = kStretches.get(swarm) ?? stretchFor(swarm);
  kStretches.set(swarm, over_s);
  const [first, count] = [fixes.firstOf(bee), fixes.countOf(bee)];
  const fix_s = Float64Array.from({ length: count }, (_, i) => fixes.timeOf(first + i));
  const height_m = Float64Array.from({ length: count }, (_, i) => start[2] + step[2] * z[first + i]);
  const gapAfter = Uint8Array.from({ length: count }, (_, i) => (fixes.isGapAfter(first + i) ? 1 : 0));
  const stretches: [number, number][] = [];
  for (let i = 0, end = 0, last = -1; i + 1 < count; ++i) {
    end = Math.max(end, i);
    while (end + 1 < count && gapAfter[end] === 0 && !(fix_s[end] > fix_s[i] && fix_s[end] - fix_s[i] >= over_s)) ++end;
    // What ends with the way before it says no more than that one.
    if (!(fix_s[end] > fix_s[i]) || (end === last && fix_s[end] - fix_s[i] < over_s)) continue;
    stretches.push([i, end]);
    last = end;
  }
  const between = (axis: ArrayLike<number>, place: number, [i, end]: [number, number]): number =>
    (step[place] * (axis[first + end] - axis[first + i])) / (fix_s[end] - fix_s[i]);
  return {
    fix_s,
    height_m,
    gapAfter,
    from_s: Float64Array.from(stretches, ([i]) => fix_s[i]),
    to_s: Float64Array.from(stretches, ([, end]) => fix_s[end]),
    horizontal_mps: Float64Array.from(stretches, (one) => Math.hypot(between(x, 0, one), between(y, 1, one))),
    climb_mps: Float64Array.from(stretches, (one) => between(z, 2, one)),
    over_s,
  };
}

/** The stretch around a time; −1 where the bee is not there. */
export function stretchAt({ from_s, to_s, over_s }: Flown, time_s: number): number {
  let [low, high] = [0, from_s.length];
  // Of stretches that overlap, the one whose middle is there.
  while (low < high) {
    const middle = (low + high) >> 1;
    if (from_s[middle] <= time_s - over_s / 2) low = middle + 1;
    else high = middle;
  }
  for (const place of [low - 1, low]) {
    if (place >= 0 && place < from_s.length && from_s[place] <= time_s && time_s <= to_s[place]) return place;
  }
  return -1;
}
