// How far apart the closest two are, moment by moment, and below it when any bee is in conflict.
// The plot is the time line too: it says where one is, and takes one elsewhere.
import type { Spans } from '../data/spans';
import type { Shown } from '../panels/shown';
import { formatTime, tellsClock, zoneWord } from '../text/calendar';
import { drawing, element } from '../text/element';
import { decimalsFor, decimalsWithin, formatCount, formatSeconds } from '../text/numbers';
import { closestAt } from './closest_at';
import type { LinkedTimes } from './linked_times';
import { measuresOf, type Measure, type Recorded } from './measures';
import { momentsWithin } from './moments';
import { clearestEnd, conflictColumns, plotScale, type PlotScale } from './plot_scales';
import { cueMarks, excessColumns } from './show_marks';
import { hatched, hatchPattern, kUnknownHere, openBands, runsOf, timeName, unknownText } from './unknown';

const kLeft = 66;
const kRight = 12;
const kTop = 17;
/** How high a curve is: alone, or one of two. */
const kCurve = { alone: 64, ofTwo: 42 };
const kStrip = 16;
const kLetter = 6.5;
const kBottom = 18;
const kGap = 9;

/** How many are so in each of so many columns of the time. */
type Counting = (columns: number, duration_s: number) => number[];

export class SeparationPlot {
  readonly box: HTMLElement;
  readonly #svg = drawing('svg', { 'aria-hidden': 'true' });
  readonly #cursor = drawing('line', { class: 'cursor' });
  readonly #tip = element('div', { class: 'plot-tip', 'aria-hidden': 'true', hidden: '' });
  readonly #recorded: Recorded[];
  readonly #measures: Measure[];
  readonly #curve_px: number;
  /** Those that declare limits have a strip of these, too. */
  readonly #limited: Recorded[];
  #width = 0;

  constructor(
    all: Shown[],
    readonly times: LinkedTimes,
  ) {
    this.#recorded = all.filter((shown): shown is Recorded => shown.swarm.kind === 'recording');
    this.#measures = measuresOf(this.#recorded);
    this.#limited = this.#recorded.filter(({ swarm }) => swarm.head.limits_kept !== undefined);
    this.#curve_px = this.#measures.length > 1 ? kCurve.ofTwo : kCurve.alone;
    const { clock } = times;
    this.box = element(
      'div',
      {
        class: 'plot',
        role: 'slider',
        tabindex: '0',
        'aria-label': timeName(this.#recorded),
        'aria-valuemin': String(clock.begins_s),
        'aria-valuemax': String(clock.ends_s),
      },
    );
    this.box.append(this.#svg, this.#tip);
    this.#listen();
    new ResizeObserver(() => this.#draw()).observe(this.box);
    clock.time.watch(() => this.#follow());
  }

  #listen(): void {
    const { clock } = this.times;
    let held = false;
    const timeUnder = (event: PointerEvent): number => {
      const { left } = this.box.getBoundingClientRect();
      const share = (event.clientX - left - kLeft) / Math.max(1, this.#width - kLeft - kRight);
      return clock.begins_s + Math.min(1, Math.max(0, share)) * (clock.ends_s - clock.begins_s);
    };
    const seek = (event: PointerEvent): void => {
      clock.pause();
      clock.go(timeUnder(event));
    };
    this.box.addEventListener('pointerdown', (event) => {
      held = true;
      this.box.setPointerCapture(event.pointerId);
      seek(event);
    });
    this.box.addEventListener('pointermove', (event) => {
      if (held) seek(event);
      if (event.pointerType === 'mouse') this.#tell(timeUnder(event));
    });
    this.box.addEventListener('pointerleave', () => (this.#tip.hidden = true));
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

  /** What there is to say of a time that is pointed at. */
  #tell(time: number): void {
    const { zero_s, calendar, clock } = this.times;
    const lines = this.#recorded.flatMap((shown) => {
      const { spans } = shown.swarm;
      const within_s = time - this.times.clockTime(shown, 0);
      const start = shown.label ? `${shown.label}: ` : '';
      const unknown = unknownText(shown.swarm, within_s);
      const risk = [`${start}${formatCount(spans.beesAt(within_s).length)} in conflict`, ...(unknown ? [unknown] : [])];
      const closest = closestAt(shown.swarm, within_s);
      if (closest === 'open') return [...risk, `closest two ${kUnknownHere}: another may be closer`];
      return closest === null ? risk : [...risk, `${closest.apart}${closest.when}: ${closest.pair}`];
    });
    const when = formatTime(zero_s + time, calendar, decimalsWithin(clock.ends_s - clock.begins_s));
    this.#tip.replaceChildren(...[when, ...lines].map((line) => element('div', {}, line)));
    this.#tip.hidden = false;
    const x = this.#xOf(time);
    const room = this.#tip.offsetWidth + 12;
    this.#tip.style.left = `${Math.max(0, x + room > this.#width ? x - room : x + 12).toFixed(0)}px`;
  }

  #follow(): void {
    const { clock, zero_s, calendar } = this.times;
    const time = clock.time.value;
    const x = this.#xOf(time).toFixed(2);
    this.#cursor.setAttribute('x1', x);
    this.#cursor.setAttribute('x2', x);
    this.box.setAttribute('aria-valuenow', time.toFixed(3));
    const unknown = this.#recorded.flatMap((shown) => unknownText(shown.swarm, this.times.within(shown)) ?? []);
    this.box.setAttribute('aria-valuetext', [formatTime(zero_s + time, calendar, decimalsFor(clock.step_s)), ...unknown].join(', '));
  }

  #xOf(time: number): number {
    const { begins_s, ends_s } = this.times.clock;
    const share = ends_s > begins_s ? (time - begins_s) / (ends_s - begins_s) : 0;
    return kLeft + share * Math.max(1, this.#width - kLeft - kRight);
  }

  #draw(): void {
    if (this.box.clientWidth === this.#width || this.box.clientWidth === 0) return;
    this.#width = this.box.clientWidth;
    const floor = this.#floor(this.#measures.length - 1);
    const strips = this.#recorded.length + this.#limited.length;
    const height = floor + kGap + strips * (kStrip + 3) + kBottom;
    this.#svg.setAttribute('viewBox', `0 0 ${this.#width} ${height}`);
    this.#svg.setAttribute('height', String(height));
    this.#svg.replaceChildren(
      hatchPattern(),
      ...this.#measures.flatMap((measure, i) => this.#panel(measure, this.#floor(i))),
      ...this.#moments(height),
      ...this.#recorded.flatMap((shown, row) => this.#strip(shown, row, floor)),
      ...this.#limited.flatMap((shown, row) => this.#limitStrip(shown, this.#recorded.length + row, floor)),
      ...cueMarks(this.#recorded, (shown, time_s) => this.#xOf(this.times.clockTime(shown, time_s)), {
        left: kLeft,
        right: this.#width - kRight,
        top: kTop,
        bottom: height - kBottom,
      }),
      this.#cursor,
    );
    this.#cursor.setAttribute('y1', String(kTop - 12));
    this.#cursor.setAttribute('y2', String(height - kBottom + 3));
    this.#follow();
  }

  /** Where the panel of a measure has its 0. */
  #floor(place: number): number {
    return kTop + (place + 1) * this.#curve_px + place * (kTop + 2);
  }

  #panel(measure: Measure, floor: number): SVGElement[] {
    const { unit } = measure;
    const distances = this.#recorded.flatMap(({ swarm }) => Array.from(measure.of(swarm), (metres) => metres / unit.metres));
    const scale = plotScale(distances, measure.limit_m / unit.metres);
    const yOf = (metres: number): number => floor - this.#curve_px * scale.shareOf(metres / unit.metres);
    const from = floor - this.#curve_px;
    const frame = drawing('svg', { x: 0, y: from, width: this.#width, height: this.#curve_px + 1, viewBox: `0 ${from} ${this.#width} ${this.#curve_px + 1}` });
    frame.append(...this.#recorded.map((shown, row) => this.#curve(shown, measure, yOf, row)));
    const open = this.#recorded.flatMap((shown) => openBands(shown.swarm.separation, (time_s) => this.#xOf(this.times.clockTime(shown, time_s)), from, this.#curve_px));
    const words = [measure.name, ...(scale.byPowersOfTen ? ['by powers of ten'] : []), ...(open.length > 0 ? ['unknown where hatched'] : [])];
    const name = drawing('text', { class: 'measure', x: this.#width - kRight, y: from - 4, 'text-anchor': 'end' }, words.join(', '));
    return [...this.#levels(scale, yOf, measure, from), ...open, frame, name];
  }

  #levels(scale: PlotScale, yOf: (metres: number) => number, { limit_m, unit }: Measure, from: number): SVGElement[] {
    const right = this.#width - kRight;
    const level = (metres: number, kind: string): SVGElement =>
      drawing('line', { class: kind, x1: kLeft, x2: right, y1: yOf(metres), y2: yOf(metres) });
    const label = (metres: number, kind: string): SVGElement =>
      drawing('text', { class: kind, x: kLeft - 6, y: yOf(metres) + 3.5, 'text-anchor': 'end' }, unit.text(metres / unit.metres));
    const levels = scale.ticks
      .map((tick) => tick * unit.metres)
      .filter((metres) => Math.abs(yOf(metres) - yOf(limit_m)) > 11 && yOf(metres) > from + 2);
    return [
      ...levels.flatMap((metres) => [level(metres, 'level'), label(metres, 'level-text')]),
      level(limit_m, 'limit'),
      label(limit_m, 'limit-text'),
    ];
  }

  #moments(height: number): SVGElement[] {
    const { clock, zero_s, calendar } = this.times;
    const [begins_s, ends_s] = [zero_s + clock.begins_s, zero_s + clock.ends_s];
    const widest = 6.3 * formatSeconds(ends_s, 1).length;
    const room = this.#width - kRight - kLeft;
    const most = Math.max(1, Math.min(this.#width / 130, room / (1.8 * (tellsClock(calendar) ? 52 : widest))));
    const moments = momentsWithin(begins_s, ends_s, calendar, most);
    // Of long numbers only as many as have room.
    let taken = 0;
    const unit = drawing('text', { class: 'level-text', x: kLeft - 6, y: height - 4, 'text-anchor': 'end' }, zoneWord(calendar));
    return [
      unit,
      ...moments.flatMap(({ time_s, text }) => {
        const half = 3.15 * text.length;
        const x = Math.max(kLeft + half, Math.min(this.#width - half, this.#xOf(time_s - zero_s)));
        if (x - half < taken) return [];
        taken = x + half + 8;
        return [drawing('text', { class: 'level-text', x, y: height - 4, 'text-anchor': 'middle' }, text)];
      }),
    ];
  }

  /** One point a pixel where there are more: the least of them, for that is what matters. */
  #curve(shown: Recorded, measure: Measure, yOf: (metres: number) => number, row: number): SVGElement {
    const { time_s, open } = shown.swarm.separation;
    const metres = measure.of(shown.swarm);
    let next = 0;
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
      while (next < open.ends_s.length && open.ends_s[next] <= before) ++next;
      const unknown = next < open.begins_s.length && open.begins_s[next] < time_s[i];
      const broken = before > -Infinity && (unknown || time_s[i] - before > gap);
      if (x !== column || broken) flush();
      if (broken) path += ' ';
      column = x;
      least = Math.min(least, metres[i]);
      before = time_s[i];
    }
    flush();
    return drawing('path', { class: `curve curve-${this.#recorded.length > 1 ? row : 'alone'}`, d: path || 'M0 0' });
  }

  #strip(shown: Recorded, row: number, floor: number): SVGElement[] {
    const { spans, unknown } = shown.swarm;
    const words = shown.label || 'in conflict';
    const columnsOf =
      ({ begins_s, ends_s }: Spans) =>
      (columns: number, duration_s: number): number[] =>
        conflictColumns(begins_s, ends_s, this.times.clockTime(shown, 0), duration_s, columns);
    return this.#columns(row, floor, words, shown.label ? 'in conflict, ' : '', columnsOf(spans), columnsOf(unknown));
  }

  #limitStrip(shown: Recorded, row: number, floor: number): SVGElement[] {
    const words = shown.label || 'over limits';
    const others = shown.swarm.head.limits_kept?.not_looked_at?.length ?? 0;
    const what = [...(shown.label ? ['over limits, '] : []), ...(others > 0 ? ['of those looked at: '] : [])].join('');
    return this.#columns(row, floor, words, what, (columns, duration_s) =>
      excessColumns(shown, this.times.clockTime(shown, 0), duration_s, columns),
    );
  }

  /** How many are so at one moment after the other. */
  #columns(row: number, floor: number, words: string, what: string, count: Counting, countUnknown: Counting = () => []): SVGElement[] {
    const from = floor + kGap + row * (kStrip + 3);
    const columns = Math.max(1, Math.floor(this.#width - kLeft - kRight));
    const duration_s = Math.max(1e-9, this.times.clock.ends_s);
    const counts = count(columns, duration_s);
    const unknown = countUnknown(columns, duration_s);
    const most = Math.max(1, ...counts);
    const mostUnknown = Math.max(0, ...unknown);
    let path = '';
    counts.forEach((count, column) => {
      if (count === 0) return;
      // One bee is seen, and as many as there ever are fill the strip.
      const tall = Math.max(3, (kStrip * count) / most);
      path += `M${kLeft + column} ${from + kStrip}h1v${-tall.toFixed(1)}h-1z`;
    });
    const found = counts.some((count) => count > 0) ? `up to ${formatCount(Math.max(...counts))} at once` : mostUnknown > 0 ? 'none known' : 'none';
    const hatch = mostUnknown > 0 ? `, up to ${formatCount(mostUnknown)} unknown (hatched)` : '';
    const measure = `${what}${found}${hatch}`;
    const right = kLeft + clearestEnd(counts.map((count, column) => count + (unknown[column] ?? 0) > 0), Math.ceil(kLetter * measure.length));
    return [
      drawing('rect', { class: 'strip', x: kLeft, y: from, width: columns, height: kStrip }),
      ...runsOf(unknown).map(([column, width]) => hatched(kLeft + column, from, width, kStrip)),
      ...(path ? [drawing('path', { class: 'strip-mark', d: path })] : []),
      drawing('text', { class: 'level-text', x: kLeft - 6, y: from + kStrip - 2, 'text-anchor': 'end' }, words.toLowerCase()),
      drawing('text', { class: 'measure', x: right - 2, y: from + kStrip - 4, 'text-anchor': 'end' }, measure),
    ];
  }
}
