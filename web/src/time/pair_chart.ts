// How far apart a pair is around its conflict: in a straight line, or horizontally and in height, each with its limit.
import type { ApartNow } from '../data/pair_ways';
import type { Recording } from '../data/recording';
import { axisUnits, lengthUnit, type AxisUnit } from '../text/apart';
import { drawing } from '../text/element';
import { niceTicks } from '../text/nice_steps';
import { formatStep } from '../text/numbers';
import { shortStep } from './moments';
import type { TimeChart } from './time_chart';

const kWidth = 360;
const kLeft = 58;
const kRight = 8;
const kRow = 78;
const kTop = 15;
const kBottom = 18;
const kPieces = 120;
/** Whatever is farther apart than so many limits leaves the chart at its top. */
const kShown = 4;

interface Row {
  name: string;
  limit_m: number;
  unit: AxisUnit;
  of: (apart: ApartNow) => number;
}

function rowsOf({ head }: Recording): Row[] {
  if (head.vertical_m === undefined) return [{ name: 'Apart', limit_m: head.threshold_m, unit: lengthUnit(head), of: ({ distance_m }) => distance_m }];
  const { horizontal, vertical } = axisUnits(head);
  return [
    { name: 'Horizontally', limit_m: head.threshold_m, unit: horizontal, of: ({ horizontal_m }) => horizontal_m },
    { name: 'In height', limit_m: head.vertical_m, unit: vertical, of: ({ height_m }) => height_m },
  ];
}

/** Null where the way of the pair is not kept. `place` is that of the conflict. */
export function pairChart(swarm: Recording, place: number, name: string): TimeChart | null {
  const span = swarm.pairWays.span(place);
  if (!span || !(span[1] > span[0])) return null;
  const { conflicts } = swarm;
  const middle_s = conflicts.closest_s[place] ?? swarm.head.risk.closest?.time_s ?? span[0];
  const rows = rowsOf(swarm);
  const xOf = (time_s: number): number => kLeft + ((time_s - span[0]) / (span[1] - span[0])) * (kWidth - kLeft - kRight);
  const height = rows.length * kRow + kBottom;
  const svg = drawing('svg', { viewBox: `0 0 ${kWidth} ${height}`, class: 'time-chart pair-chart', role: 'img', 'aria-label': name });
  const instants = swarm.pairWays.instants(place, kPieces);
  if (place < conflicts.begins_s.length) {
    const [from, to] = [xOf(Math.max(span[0], conflicts.begins_s[place])), xOf(Math.min(span[1], conflicts.ends_s[place]))];
    svg.append(drawing('rect', { class: 'band', x: from, y: kTop - 4, width: Math.max(1, to - from), height: height - kBottom - kTop + 4 }));
  }
  rows.forEach((row, i) => svg.append(...drawRow(row, i * kRow, swarm, place, instants, xOf)));
  svg.append(...momentsAround(middle_s, span, xOf, height - 4));
  const cursor = drawing('line', { class: 'cursor', y1: kTop - 6, y2: height - kBottom + 3 });
  svg.append(cursor);
  return {
    svg: svg as SVGSVGElement,
    follow: (within_s) => {
      const seen = swarm.pairWays.covers(place, within_s);
      cursor.setAttribute('visibility', seen ? 'visible' : 'hidden');
      if (!seen) return;
      for (const end of ['x1', 'x2']) cursor.setAttribute(end, xOf(within_s).toFixed(1));
    },
    timeAt: (share) => span[0] + ((share * kWidth - kLeft) / (kWidth - kLeft - kRight)) * (span[1] - span[0]),
  };
}

/** Even steps before and after the closest moment, as many as have room. */
function momentsAround(middle_s: number, span: [number, number], xOf: (time_s: number) => number, y: number): SVGElement[] {
  // The closest moment is one of them, however its time was rounded.
  const [from, to] = [Math.min(0, span[0] - middle_s), Math.max(0, span[1] - middle_s)];
  for (let step_s = shortStep((to - from) / 8); ; step_s = shortStep(1.01 * step_s)) {
    const steps = Array.from({ length: Math.max(0, Math.floor(to / step_s) - Math.ceil(from / step_s)) + 1 }, (_, i) => i + Math.ceil(from / step_s));
    const moments = steps.map((step) => {
      const text = step === 0 ? 'closest' : `${step > 0 ? '+' : '\u2212'}${formatStep(Math.abs(step) * step_s)}`;
      const half = 3.2 * text.length;
      return { text, half, x: Math.max(half, Math.min(kWidth - half, xOf(middle_s + step * step_s))) };
    });
    const crowded = moments.some(({ x, half }, i) => i > 0 && x - half < moments[i - 1].x + moments[i - 1].half + 6);
    if (crowded && step_s < to - from) continue;
    return moments.map(({ text, x }) => drawing('text', { class: 'level-text', x, y, 'text-anchor': 'middle' }, text));
  }
}

function drawRow(
  row: Row,
  top: number,
  swarm: Recording,
  place: number,
  instants: number[],
  xOf: (time_s: number) => number,
): SVGElement[] {
  const values = instants.map((time_s) => {
    const apart = swarm.pairWays.at(place, time_s);
    return apart ? row.of(apart) : NaN;
  });
  const most = Math.max(1.25 * row.limit_m, ...values.filter((value) => value < kShown * row.limit_m));
  const floor = top + kRow;
  const yOf = (metres: number): number => floor - (Math.min(metres, 3 * most) / most) * (kRow - kTop);
  let path = '';
  values.forEach((value, i) => {
    if (Number.isFinite(value)) path += `${path === '' ? 'M' : 'L'}${xOf(instants[i]).toFixed(1)} ${yOf(value).toFixed(1)}`;
  });
  const clear = (metres: number): boolean => Math.abs(yOf(metres) - yOf(row.limit_m)) > 11;
  const { unit } = row;
  const levels = niceTicks(0, most / unit.metres, 2)
    .map((tick) => tick * unit.metres)
    .filter((metres) => clear(metres) && yOf(metres) > top + kTop - 2);
  const line = (metres: number, kind: string): SVGElement =>
    drawing('line', { class: kind, x1: kLeft, x2: kWidth - kRight, y1: yOf(metres), y2: yOf(metres) });
  const label = (metres: number, kind: string): SVGElement =>
    drawing('text', { class: kind, x: kLeft - 5, y: yOf(metres) + 3.5, 'text-anchor': 'end' }, unit.text(metres / unit.metres));
  return [
    ...levels.flatMap((metres) => [line(metres, 'level'), label(metres, 'level-text')]),
    line(row.limit_m, 'limit'),
    label(row.limit_m, 'limit-text'),
    drawing('text', { class: 'row-name', x: kWidth - kRight, y: top + kTop - 5, 'text-anchor': 'end' }, row.name),
    drawing(
      'svg',
      { x: 0, y: top + kTop - 6, width: kWidth, height: kRow - kTop + 7, viewBox: `0 ${top + kTop - 6} ${kWidth} ${kRow - kTop + 7}` },
      drawing('path', { class: 'curve curve-alone', d: path || 'M0 0' }),
    ),
  ];
}
