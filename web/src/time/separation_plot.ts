// How far apart the closest two are, moment by moment, and below it when any bee is in conflict.
// The plot is the time line too: it says where one is, and takes one elsewhere.
import type { Recording } from '../data/recording';
import type { Shown } from '../panels/shown';
import { drawing, element } from '../text/element';
import { niceTicks } from '../text/nice_steps';
import { decimalsFor, formatExactly, formatTick, formatTime } from '../text/numbers';
import type { LinkedTimes } from './linked_times';

const kLeft = 52;
const kRight = 12;
const kTop = 8;
const kCurve = 64;
const kStrip = 11;
const kBottom = 18;
const kGap = 9;

type Recorded = Shown & { swarm: Recording };

/** How many bees are in conflict, for each of `columns` equal parts of the clock's time. */
export function conflictColumns(
  begins_s: Float64Array,
  ends_s: Float64Array,
  shift_s: number,
  duration_s: number,
  columns: number,
): number[] {
  const changes = new Array<number>(columns + 1).fill(0);
  const columnOf = (time: number): number =>
    Math.min(columns - 1, Math.max(0, Math.floor(((time + shift_s) / duration_s) * columns)));
  for (let i = 0; i < begins_s.length; ++i) {
    changes[columnOf(begins_s[i])]++;
    changes[columnOf(ends_s[i]) + 1]--;
  }
  let now = 0;
  return changes.slice(0, columns).map((change) => (now += change));
}

/** Height of the plot: the threshold is well seen, and rare great distances do not flatten the rest. */
export function plotTop(distances: number[], threshold_m: number): number {
  if (distances.length === 0) return 2 * threshold_m || 1;
  const sorted = distances.slice().sort((a, b) => a - b);
  const usual = sorted[Math.floor(0.9 * (sorted.length - 1))];
  return Math.max(1.6 * threshold_m, Math.min(1.15 * usual, 12 * threshold_m || Infinity)) || 1;
}

export class SeparationPlot {
  readonly box: HTMLElement;
  readonly #svg = drawing('svg', { 'aria-hidden': 'true' });
  readonly #cursor = drawing('line', { class: 'cursor' });
  readonly #recorded: Recorded[];
  #width = 0;

  constructor(
    all: Shown[],
    readonly times: LinkedTimes,
  ) {
    this.#recorded = all.filter((shown): shown is Recorded => shown.swarm.kind === 'recording');
    const { clock } = times;
    this.box = element(
      'div',
      {
        class: 'plot',
        role: 'slider',
        tabindex: '0',
        'aria-label': 'Time',
        'aria-valuemin': String(clock.begins_s),
        'aria-valuemax': String(clock.ends_s),
      },
    );
    this.box.append(this.#svg);
    this.#listen();
    new ResizeObserver(() => this.#draw()).observe(this.box);
    clock.time.watch(() => this.#follow());
  }

  #listen(): void {
    const { clock } = this.times;
    let held = false;
    const seek = (event: PointerEvent): void => {
      const { left } = this.box.getBoundingClientRect();
      const share = (event.clientX - left - kLeft) / Math.max(1, this.#width - kLeft - kRight);
      clock.pause();
      clock.go(clock.begins_s + share * (clock.ends_s - clock.begins_s));
    };
    this.box.addEventListener('pointerdown', (event) => {
      held = true;
      this.box.setPointerCapture(event.pointerId);
      seek(event);
    });
    this.box.addEventListener('pointermove', (event) => held && seek(event));
    for (const end of ['pointerup', 'pointercancel'] as const) {
      this.box.addEventListener(end, () => (held = false));
    }
    this.box.addEventListener('keydown', (event) => {
      const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 }[event.key];
      if (steps === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      clock.step(steps);
    });
  }

  #follow(): void {
    const { clock, zero_s, since1970 } = this.times;
    const time = clock.time.value;
    const x = this.#xOf(time).toFixed(2);
    this.#cursor.setAttribute('x1', x);
    this.#cursor.setAttribute('x2', x);
    this.box.setAttribute('aria-valuenow', time.toFixed(3));
    this.box.setAttribute('aria-valuetext', formatTime(zero_s + time, since1970, decimalsFor(clock.step_s)));
  }

  #xOf(time: number): number {
    const { begins_s, ends_s } = this.times.clock;
    const share = ends_s > begins_s ? (time - begins_s) / (ends_s - begins_s) : 0;
    return kLeft + share * Math.max(1, this.#width - kLeft - kRight);
  }

  #draw(): void {
    if (this.box.clientWidth === this.#width || this.box.clientWidth === 0) return;
    this.#width = this.box.clientWidth;
    const height = kTop + kCurve + kGap + this.#recorded.length * (kStrip + 3) + kBottom;
    this.#svg.setAttribute('viewBox', `0 0 ${this.#width} ${height}`);
    this.#svg.setAttribute('height', String(height));
    const threshold = Math.max(...this.#recorded.map(({ swarm }) => swarm.head.threshold_m));
    const distances = this.#recorded.flatMap(({ swarm }) => Array.from(swarm.separation.distance_m));
    const top = plotTop(distances, threshold);
    // Whatever is farther apart leaves the plot at its top.
    const yOf = (metres: number): number => kTop + kCurve * (1 - Math.min(4, metres / top));
    const frame = drawing('svg', { x: 0, y: kTop, width: this.#width, height: kCurve + 1, viewBox: `0 ${kTop} ${this.#width} ${kCurve + 1}` });
    frame.append(...this.#recorded.map((shown, row) => this.#curve(shown, yOf, row)));
    this.#svg.replaceChildren(
      ...this.#scales(top, yOf, threshold, height),
      frame,
      ...this.#recorded.flatMap((shown, row) => this.#strip(shown, row)),
      this.#cursor,
    );
    this.#cursor.setAttribute('y1', String(kTop - 4));
    this.#cursor.setAttribute('y2', String(height - kBottom + 3));
    this.#follow();
  }

  #scales(top: number, yOf: (metres: number) => number, threshold: number, height: number): SVGElement[] {
    const right = this.#width - kRight;
    const { clock, zero_s, since1970 } = this.times;
    const level = (metres: number, kind: string): SVGElement[] => [
      drawing('line', { class: kind, x1: kLeft, x2: right, y1: yOf(metres), y2: yOf(metres) }),
    ];
    const label = (metres: number, text: string, kind: string): SVGElement =>
      drawing('text', { class: kind, x: kLeft - 6, y: yOf(metres) + 3.5, 'text-anchor': 'end' }, text);
    const levels = niceTicks(0, top, 2).filter(
      (metres) => Math.abs(yOf(metres) - yOf(threshold)) > 11 && yOf(metres) > kTop + 2,
    );
    const textOf = (moment: number, decimals: number): string => {
      const full = formatTime(moment, since1970, decimals);
      return since1970 ? full.slice(11, 19) : full;
    };
    const widest = 6.3 * textOf(zero_s + clock.ends_s, 1).length;
    const most = Math.max(1, Math.min(this.#width / 130, (right - kLeft) / (1.8 * widest)));
    const moments = niceTicks(zero_s + clock.begins_s, zero_s + clock.ends_s, most);
    const decimals = moments.length > 1 ? decimalsFor(moments[1] - moments[0]) : 1;
    return [
      ...levels.flatMap((metres) => [...level(metres, 'level'), label(metres, formatTick(metres), 'level-text')]),
      ...level(threshold, 'limit'),
      label(threshold, formatExactly(threshold), 'limit-text'),
      ...moments.map((moment) => {
        const text = textOf(moment, decimals);
        const half = 3.15 * text.length;
        const x = Math.max(half, Math.min(this.#width - half, this.#xOf(moment - zero_s)));
        return drawing('text', { class: 'level-text', x, y: height - 4, 'text-anchor': 'middle' }, text);
      }),
    ];
  }

  /** One point a pixel where there are more: the least of them, for that is what matters. */
  #curve(shown: Recorded, yOf: (metres: number) => number, row: number): SVGElement {
    const { time_s, distance_m } = shown.swarm.separation;
    const gap = 4 * ((time_s[time_s.length - 1] - time_s[0]) / Math.max(1, time_s.length - 1));
    let path = '';
    let column = -1;
    let least = Infinity;
    let before = -Infinity;
    const flush = (): void => {
      if (column < 0) return;
      path += `${path === '' || path.endsWith(' ') ? 'M' : 'L'}${column} ${yOf(least).toFixed(1)}`;
      least = Infinity;
    };
    for (let i = 0; i < time_s.length; ++i) {
      const x = Math.round(this.#xOf(this.times.clockTime(shown, time_s[i])));
      const broken = time_s[i] - before > gap && before > -Infinity;
      if (x !== column || broken) flush();
      if (broken) path += ' ';
      column = x;
      least = Math.min(least, distance_m[i]);
      before = time_s[i];
    }
    flush();
    return drawing('path', { class: `curve curve-${this.#recorded.length > 1 ? row : 'alone'}`, d: path || 'M0 0' });
  }

  #strip(shown: Recorded, row: number): SVGElement[] {
    const { clock } = this.times;
    const from = kTop + kCurve + kGap + row * (kStrip + 3);
    const columns = Math.max(1, Math.floor(this.#width - kLeft - kRight));
    const { begins_s, ends_s } = shown.swarm.spans;
    const shift = this.times.clockTime(shown, 0);
    const counts = conflictColumns(begins_s, ends_s, shift, Math.max(1e-9, clock.ends_s), columns);
    let path = '';
    counts.forEach((count, column) => {
      if (count === 0) return;
      const tall = Math.min(kStrip, 4 + 1.6 * Math.log2(count));
      path += `M${kLeft + column} ${from + kStrip}h1v${-tall.toFixed(1)}h-1z`;
    });
    const words = shown.label || 'conflicts';
    return [
      drawing('rect', { class: 'strip', x: kLeft, y: from, width: columns, height: kStrip }),
      ...(path ? [drawing('path', { class: 'strip-mark', d: path })] : []),
      drawing('text', { class: 'level-text', x: kLeft - 6, y: from + kStrip - 2, 'text-anchor': 'end' }, words.toLowerCase()),
    ];
  }
}
