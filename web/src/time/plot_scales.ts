// How high curves and columns of the time line are.
import { niceTicks } from '../text/nice_steps';

/** How many bees are in conflict, for each of `columns` equal parts of the clock's time. */
export function conflictColumns(
  begins_s: Float64Array,
  ends_s: Float64Array,
  shift_s: number,
  duration_s: number,
  columns: number,
): number[] {
  const columnOf = (time: number): number =>
    Math.min(columns - 1, Math.max(0, Math.floor(((time + shift_s) / duration_s) * columns)));
  const begins = Float64Array.from(begins_s).sort();
  const ends = Float64Array.from(ends_s).sort();
  const most = new Array<number>(columns).fill(0);
  // Those that go on in a column, and begin in it before others end: never more than there are at one moment.
  let [now, ended, column] = [0, 0, 0];
  const endUntil = (time: number, behind: number): void => {
    while (ended < ends.length && ends[ended] < time) {
      const last = columnOf(ends[ended++]);
      for (; column < last; ) most[++column] = now;
      --now;
    }
    for (; column < behind; ) most[++column] = now;
  };
  for (const time of begins) {
    endUntil(time, columnOf(time));
    most[column] = Math.max(most[column], ++now);
  }
  endUntil(Infinity, columns - 1);
  return most;
}

/** Where a distance is in a plot: at its floor 0, at its top 1. */
export interface PlotScale {
  byPowersOfTen: boolean;
  shareOf: (metres: number) => number;
  ticks: number[];
}

/** What is spread over more than so many thresholds is shown by powers of ten, as in the pictures of `beespace plot`. */
const kWide = 12;
/** What is closer than so small a share of the threshold is at the floor. */
const kClosest = 1e-3;

/** All distances are in the plot, the threshold is well seen, and rare great ones do not flatten the rest. */
export function plotScale(distances: ArrayLike<number>, threshold_m: number): PlotScale {
  let [least, most] = [Infinity, 0];
  for (let i = 0; i < distances.length; ++i) {
    const metres = distances[i];
    if (metres > 0 && metres < least) least = metres;
    if (metres > most && metres < Infinity) most = metres;
  }
  if (threshold_m > 0 && most > kWide * threshold_m) return logarithmic(Math.min(Math.max(least, kClosest * threshold_m), threshold_m / 2), most);
  const top = Math.max(1.6 * threshold_m, 1.1 * most) || 1;
  return { byPowersOfTen: false, shareOf: (metres) => metres / top, ticks: niceTicks(0, top, 2) };
}

function logarithmic(least: number, most: number): PlotScale {
  const [from, to] = [Math.log10(0.8 * least), Math.log10(1.25 * most)];
  const powers = Array.from({ length: Math.floor(to) - Math.ceil(from) + 1 }, (_, i) => Math.ceil(from) + i);
  const every = Math.ceil(powers.length / 3);
  return {
    byPowersOfTen: true,
    shareOf: (metres) => Math.max(0, (Math.log10(Math.max(metres, 1e-300)) - from) / (to - from)),
    ticks: powers.filter((_, i) => (powers.length - 1 - i) % every === 0).map((power) => 10 ** power),
  };
}

/** Where so many columns end that cover the fewest marked ones: as far to the right as that allows. */
export function clearestEnd(marked: boolean[], length: number): number {
  const before = [0];
  for (const one of marked) before.push(before[before.length - 1] + (one ? 1 : 0));
  let best = marked.length;
  const covered = (end: number): number => before[end] - before[Math.max(0, end - length)];
  for (let end = marked.length; end >= Math.min(marked.length, length); --end) {
    if (covered(end) < covered(best)) best = end;
  }
  return best;
}
