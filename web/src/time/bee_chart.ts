// How high and how fast a bee flies over time, and what its show allows: from the positions as they are shown. Where it is
// beyond a limit was decided along its curves, and is a band here.
import { flownBy, type Flown } from '../data/flown';
import type { LimitName, RecordingTime } from '../data/page';
import type { Recording } from '../data/recording';
import { drawing } from '../text/element';
import { kFoot_m } from '../text/heights';
import { niceTicks } from '../text/nice_steps';
import { formatCount } from '../text/numbers';
import { kFootAMinute_mps, kKnot_mps } from '../text/speeds';
import { momentsWithin } from './moments';
import type { TimeChart } from './time_chart';

const kWidth = 360;
const kLeft = 46;
const kRight = 8;
const kRow = 66;
const kTop = 16;
const kBottom = 18;
/** A limit that is so many times as much as what is flown would flatten the curve: it is only named. */
const kFar = 4;

interface Limit {
  name: LimitName;
  /** As it stands in the row: a descent is a climb below nothing. */
  value: number;
}

interface Row {
  name: string;
  unit: string;
  /** What the unit is in metres or metres a second. */
  of: number;
  points: (flown: Flown) => [time_s: number, value: number][];
  limits: Limit[];
  /** Whether nothing belongs to the row. */
  fromZero: boolean;
}

const kGap: [number, number] = [NaN, NaN];

function tickText(value: number): string {
  return Math.abs(value) >= 1000 ? formatCount(value) : String(Number(value.toPrecision(6))).replace('-', '\u2212');
}

function heightPoints({ fix_s, height_m, gapAfter }: Flown): [number, number][] {
  return Array.from(fix_s).flatMap((time_s, i) => {
    const here: [number, number] = [time_s, height_m[i]];
    return gapAfter[i] ? [here, kGap] : [here];
  });
}

/** At the middles of stretches, and at the ends of what is flown without a gap. */
function speedPoints({ from_s, to_s }: Flown, speeds: Float64Array): [number, number][] {
  const points: [number, number][] = [];
  for (let i = 0; i < speeds.length; ++i) {
    const begins = i === 0 || from_s[i] > to_s[i - 1];
    const ends = i + 1 === speeds.length || from_s[i + 1] > to_s[i];
    if (begins) points.push([from_s[i], speeds[i]]);
    points.push([(from_s[i] + to_s[i]) / 2, speeds[i]]);
    if (ends) points.push([to_s[i], speeds[i]], kGap);
  }
  return points;
}

function rowsOf({ head }: Recording): Row[] {
  const inFeet = head.heights?.in_feet ?? false;
  const declared = head.limits_kept?.greatest ?? [];
  const limitsOf = (...names: LimitName[]): Limit[] =>
    declared.flatMap(({ limit, most }) => (names.includes(limit) ? [{ name: limit, value: limit === 'descent' ? -most : most }] : []));
  const speed: Row = {
    name: head.flat ? 'Speed' : head.origin ? 'Ground speed' : 'Horizontal speed',
    unit: inFeet ? 'kt' : 'm/s',
    of: inFeet ? kKnot_mps : 1,
    points: (flown) => speedPoints(flown, flown.horizontal_mps),
    limits: limitsOf('horizontal'),
    fromZero: true,
  };
  if (head.flat) return [speed];
  const height: Row = { name: 'Height', unit: inFeet ? 'ft' : 'm', of: inFeet ? kFoot_m : 1, points: heightPoints, limits: limitsOf('height'), fromZero: false };
  const climb: Row = {
    name: 'Climb',
    unit: inFeet ? 'ft/min' : 'm/s',
    of: inFeet ? kFootAMinute_mps : 1,
    points: (flown) => speedPoints(flown, flown.climb_mps),
    limits: limitsOf('climb', 'descent'),
    fromZero: true,
  };
  return [height, speed, climb];
}

/** Of the bee, and of another one beside it; null where neither flies. */
export function beeChart(swarm: Recording, bee: number, other: number | null, name: string): TimeChart | null {
  const flown = [bee, ...(other === null ? [] : [other])].map((one) => flownBy(swarm, one));
  const { begins_s, ends_s } = swarm.head.time;
  const duration_s = ends_s - begins_s;
  if (!(duration_s > 0) || flown.every(({ fix_s }) => fix_s.length < 2)) return null;
  const xOf = (time_s: number): number => kLeft + (Math.min(duration_s, Math.max(0, time_s)) / duration_s) * (kWidth - kLeft - kRight);
  const rows = rowsOf(swarm);
  const height = rows.length * kRow + kBottom;
  const svg = drawing('svg', { viewBox: `0 0 ${kWidth} ${height}`, class: 'time-chart bee-chart', role: 'img', 'aria-label': name });
  rows.forEach((row, i) => svg.append(...drawRow(row, i * kRow, swarm, bee, flown, xOf)));
  svg.append(...moments(swarm.head.time, xOf, height - 4));
  const cursor = drawing('line', { class: 'cursor', y1: kTop - 6, y2: height - kBottom + 3 });
  svg.append(cursor);
  return {
    svg: svg as SVGSVGElement,
    follow: (within_s) => {
      for (const end of ['x1', 'x2']) cursor.setAttribute(end, xOf(within_s).toFixed(1));
    },
    timeAt: (share) => ((share * kWidth - kLeft) / (kWidth - kLeft - kRight)) * duration_s,
  };
}

function moments(time: RecordingTime, xOf: (time_s: number) => number, y: number): SVGElement[] {
  let taken = -Infinity;
  return momentsWithin(time.begins_s, time.ends_s, time, 3).flatMap(({ time_s, text }) => {
    const half = 3.1 * text.length;
    const x = Math.min(kWidth - half, Math.max(half, xOf(time_s - time.begins_s)));
    if (x - half < taken) return [];
    taken = x + half + 8;
    return [drawing('text', { class: 'level-text', x, y, 'text-anchor': 'middle' }, text)];
  });
}

function drawRow(row: Row, top: number, swarm: Recording, bee: number, flown: Flown[], xOf: (time_s: number) => number): SVGElement[] {
  const curves = flown.map((one) => row.points(one).map(([time_s, value]): [number, number] => [time_s, value / row.of]));
  const values = curves.flat().flatMap(([, value]) => (Number.isFinite(value) ? [value] : []));
  const none = row.fromZero ? [0, 0] : [Infinity, -Infinity];
  const [lowest, highest] = values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], none);
  const reach = Math.max(Math.abs(lowest), Math.abs(highest));
  const near = row.limits.filter(({ value }) => Math.abs(value / row.of) <= kFar * reach);
  const [least, most] = [Math.min(lowest, ...near.map(({ value }) => value / row.of)), Math.max(highest, ...near.map(({ value }) => value / row.of))];
  const room = 0.08 * (most - least) || Math.max(1, 0.05 * Math.abs(most));
  const floor = top + kRow - 3;
  const yOf = (value: number): number => floor - ((value - least + room) / (most - least + 2 * room)) * (kRow - kTop - 3);
  const label = (value: number, kind: string): SVGElement =>
    drawing('text', { class: kind, x: kLeft - 5, y: yOf(value) + 3.5, 'text-anchor': 'end' }, tickText(value));
  const line = (value: number, kind: string): SVGElement => drawing('line', { class: kind, x1: kLeft, x2: kWidth - kRight, y1: yOf(value), y2: yOf(value) });
  const free = (value: number): boolean => near.every((limit) => Math.abs(yOf(value) - yOf(limit.value / row.of)) > 11);
  const far = row.limits.filter((limit) => !near.includes(limit)).map(({ value }) => `, limit ${tickText(value / row.of)}`);
  return [
    ...bands(row, top, swarm, bee, xOf),
    ...niceTicks(least - room, most + room, 2).flatMap((value) => [line(value, 'level'), ...(free(value) ? [label(value, 'level-text')] : [])]),
    ...near.flatMap(({ value }) => [line(value / row.of, 'limit'), label(value / row.of, 'limit-text')]),
    drawing('text', { class: 'row-name', x: kWidth - kRight, y: top + kTop - 5, 'text-anchor': 'end' }, `${row.name}, ${row.unit}${far.join('')}`),
    // The bee itself lies over the other one.
    ...curves.map((points, i) => drawing('path', { class: i === 0 ? 'curve curve-alone' : 'curve curve-other', d: pathOf(points, xOf, yOf) })).reverse(),
  ];
}

function bands(row: Row, top: number, { head }: Recording, bee: number, xOf: (time_s: number) => number): SVGElement[] {
  const { greatest = [], excesses = [] } = head.limits_kept ?? {};
  return excesses.flatMap((excess) => {
    if (excess.bee !== bee || !row.limits.some(({ name }) => name === greatest[excess.limit].limit)) return [];
    const [from, to] = [xOf(excess.begins_s), xOf(excess.ends_s)];
    return [drawing('rect', { class: 'band', x: from, y: top + kTop - 3, width: Math.max(2, to - from), height: kRow - kTop })];
  });
}

/** Of very many points, in each column the first, the least, the greatest and the last. */
function pathOf(points: [number, number][], xOf: (time_s: number) => number, yOf: (value: number) => number): string {
  let path = '';
  let column = NaN;
  let ys: number[] = [];
  let broken = true;
  const flush = (): void => {
    if (ys.length === 0) return;
    const kept = ys.length <= 4 ? ys : [ys[0], Math.min(...ys), Math.max(...ys), ys[ys.length - 1]];
    for (const y of kept) {
      path += `${broken ? 'M' : 'L'}${column} ${y.toFixed(1)}`;
      broken = false;
    }
    ys = [];
  };
  for (const [time_s, value] of points) {
    const x = Math.round(2 * xOf(time_s)) / 2;
    if (x !== column || !Number.isFinite(value)) flush();
    column = x;
    if (Number.isFinite(value)) ys.push(yOf(value));
    else broken = true;
  }
  flush();
  return path || 'M0 0';
}
