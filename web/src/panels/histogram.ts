// How the distances to the nearest bee are distributed, and where the threshold lies among them.
import type { Snapshot } from '../data/snapshot';
import { quantileCode, type Nearest } from '../data/nearest';
import { drawing, element, panel } from '../text/element';
import { formatExactly, formatMetres, formatTick } from '../text/numbers';
import { counted, nounOfAll } from '../text/noun';
import type { Shown } from './shown';

const kWidth = 360;
const kHeight = 92;
const kLeft = 4;
const kFloor = 72;
const kBins = 60;

export interface Bins {
  counts: number[];
  /** Of these, the ones at risk. */
  atRisk: number[];
}

/** Bees by the distance to their nearest, in bins of equal ratio between two distances; beyond these in the outermost. */
export function binDistances(
  nearest: Nearest,
  isAtRisk: (bee: number) => boolean,
  range_m: [number, number],
  bins: number,
): Bins {
  const counts = new Array<number>(bins).fill(0);
  const atRisk = new Array<number>(bins).fill(0);
  const least = Math.log(range_m[0]);
  const width = (Math.log(range_m[1]) - least) / bins;
  const binOf = (code: number): number => {
    const bin = Math.floor((Math.log(nearest.ofCode(code)) - least) / width);
    return Math.min(bins - 1, Math.max(0, bin));
  };
  const binOfCode = Int16Array.from({ length: 65536 }, (_, code) => binOf(code));
  for (let bee = 0; bee < nearest.codes.length; ++bee) {
    const bin = binOfCode[nearest.codes[bee]];
    counts[bin]++;
    if (isAtRisk(bee)) atRisk[bin]++;
  }
  return { counts, atRisk };
}

/** The range, a little wider, so that the threshold lies between two bins and not within one. */
export function alignedRange([least_m, most_m]: [number, number], threshold_m: number, bins: number): [number, number] {
  if (!(threshold_m > least_m)) return [least_m, most_m];
  const width = Math.log(most_m / least_m) / (bins - 1);
  const below = Math.ceil(Math.log(threshold_m / least_m) / width);
  const start = threshold_m / Math.exp(below * width);
  return [start, start * Math.exp(bins * width)];
}

/** Distances to write below: 1, 2 and 5 with zeros, or only 1 where these are too many. */
export function distanceTicks(least_m: number, most_m: number): number[] {
  const ticks: number[] = [];
  const decades = Math.log10(most_m / least_m);
  const digits = decades > 3 ? [1] : decades > 1.2 ? [1, 3] : [1, 2, 5];
  for (let power = Math.floor(Math.log10(least_m)); power <= Math.log10(most_m); ++power) {
    for (const digit of digits) {
      const tick = Number((digit * 10 ** power).toPrecision(6));
      if (tick >= least_m && tick <= most_m) ticks.push(tick);
    }
  }
  return ticks.length > 7 ? ticks.filter((_, i) => i % Math.ceil(ticks.length / 7) === 0) : ticks;
}

function rangeOf(all: { nearest: Nearest; threshold_m: number }[]): [number, number] {
  // In metres, as two swarms need not have the same codes.
  const least = all.map(({ nearest, threshold_m }) => {
    const low = nearest.ofCode(Math.max(1, quantileCode(nearest.countCodes(), 0.001)));
    return threshold_m > 0 ? Math.min(low, threshold_m) : low;
  });
  const most = all.map(({ nearest, threshold_m }) =>
    Math.max(nearest.ofCode(quantileCode(nearest.countCodes(), 0.9995)), threshold_m),
  );
  return [Math.min(...least) / 1.1, Math.max(...most) * 1.1];
}

function chart(swarm: Snapshot, nearest: Nearest, range_m: [number, number], name: string): SVGElement {
  const logs = range_m.map(Math.log);
  const xOf = (metres: number): number =>
    kLeft + ((Math.log(metres) - logs[0]) / (logs[1] - logs[0])) * (kWidth - 2 * kLeft);
  const bins = binDistances(nearest, swarm.isAtRisk, range_m, kBins);
  const highest = Math.max(1, ...bins.counts);
  const width = (kWidth - 2 * kLeft) / kBins;
  const bar = (bin: number, count: number, kind: string): SVGRectElement | null => {
    if (count === 0) return null;
    // A single bee is still seen among a million.
    const height = Math.max(1.5, (count / highest) * (kFloor - 16));
    return drawing('rect', { class: kind, x: kLeft + bin * width, y: kFloor - height, width: width - 0.6, height });
  };
  const bars = bins.counts.flatMap((count, bin) => [bar(bin, count, 'bar'), bar(bin, bins.atRisk[bin], 'bar risk')]);
  // On a scale of ratios nothing has no place.
  const limit = xOf(Math.max(range_m[0], swarm.head.threshold_m));
  const rightHalf = limit > kWidth * 0.6;
  const ticks = distanceTicks(range_m[0], range_m[1]).flatMap((tick) => {
    const text = formatTick(tick);
    const half = 3 * text.length;
    const x = Math.min(kWidth - half, Math.max(half, xOf(tick)));
    return [
      drawing('line', { class: 'tick', x1: xOf(tick), x2: xOf(tick), y1: kFloor, y2: kFloor + 4 }),
      drawing('text', { class: 'tick-text', x, y: kFloor + 16 }, text),
    ];
  });
  return drawing(
    'svg',
    { viewBox: `0 0 ${kWidth} ${kHeight}`, role: 'img', 'aria-label': name },
    ...bars.filter((one) => one !== null),
    drawing('line', { class: 'floor', x1: 0, x2: kWidth, y1: kFloor, y2: kFloor }),
    ...ticks,
    drawing('line', { class: 'limit', x1: limit, x2: limit, y1: 2, y2: kFloor }),
    drawing(
      'text',
      { class: 'limit-text', x: rightHalf ? limit - 5 : limit + 5, y: 11, 'text-anchor': rightHalf ? 'end' : 'start' },
      `${swarm.head.vertical_m === undefined ? 'threshold' : 'horizontally'} ${formatExactly(swarm.head.threshold_m)}`,
    ),
  );
}

/** Nothing where no swarm has a nearest distance, as in recordings. */
export function histogramPanel(all: Shown[]): HTMLElement | null {
  const known = all.flatMap(({ swarm, label }) =>
    swarm.kind === 'snapshot' && swarm.nearest ? [{ swarm, nearest: swarm.nearest, label }] : [],
  );
  if (known.length === 0) return null;
  const noun = nounOfAll(all);
  const around_m = rangeOf(known.map(({ swarm, nearest }) => ({ nearest, threshold_m: swarm.head.threshold_m })));
  const range_m = alignedRange(around_m, known[0].swarm.head.threshold_m, kBins);
  const figures = known.map(({ swarm, nearest, label }) => {
    const median = formatMetres(nearest.ofCode(quantileCode(nearest.countCodes(), 0.5)), 3);
    const text = `Half of ${counted(swarm.head.count, noun)} have another one within ${median}.`;
    const name = `Histogram of the distances to the nearest ${noun.one}. ${text}`;
    return element(
      'figure',
      {},
      label ? element('h3', {}, label) : null,
      chart(swarm, nearest, range_m, label ? `${label}: ${name}` : name),
      element('figcaption', {}, text),
    );
  });
  return panel('histogram', `Distance to the nearest ${noun.one}`, ...figures);
}
