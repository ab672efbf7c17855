// What the colours of bees tell: how near the nearest one is, how high or how fast a bee flies, or in which group of
// those who are too close it is.
import type { Nearest } from '../data/nearest';
import { speedsOf } from '../data/speeds';
import { pairsOf, type Company, type Swarm } from '../data/swarm';
import type { Triple } from '../data/positions';
import type { ColourBy } from '../state/choices';
import { lengthUnits } from '../text/apart';
import { kFoot_m } from '../text/heights';
import { nounOf } from '../text/noun';
import { formatCount, formatDigits, formatMetres, formatTick } from '../text/numbers';
import { kKnot_mps } from '../text/speeds';
import { Crowding } from './crowding';
import type { Placement } from './placement';

/** Groups have so many colours, in turn. */
export const kGroupColours = 7;

export interface Colouring {
  by: ColourBy;
  /** A number of each bee; null: all have the same colour. */
  codes: Uint16Array | null;
  /** Numbers of the first and the last colour. */
  range: [number, number];
  title: string;
  /** What the first and the last colour mean. */
  ends: [string, string];
}

const kPlain: Colouring = { by: 'none', codes: null, range: [0, 1], title: '', ends: ['', ''] };

function nearestColouring({ head }: Swarm, nearest: Nearest, range: [number, number], title: string): Colouring {
  const text = (metres: number): string => {
    const unit = lengthUnits(head).ground(metres);
    return head.aviation ? unit.text(Number((metres / unit.metres).toPrecision(2))) : formatMetres(metres, 2);
  };
  const [near, far] = range.map((code) => text(nearest.ofCode(Math.round(code))));
  return { by: 'nearest', codes: nearest.codes, range, title, ends: [`≤\u202f${near}`, `≥\u202f${far}`] };
}

function ofNearest(swarm: Swarm, crowding: Crowding | null): Colouring | null {
  if (crowding) return nearestColouring(swarm, crowding.nearest, Crowding.range(crowding.nearest), `Nearest ${nounOf(swarm.head).one}, as shown`);
  if (swarm.kind !== 'snapshot' || !swarm.nearest) return null;
  const [near, far] = middleOf(swarm.nearest.codes);
  return nearestColouring(swarm, swarm.nearest, [near, Math.max(near + 1, far)], `Nearest ${nounOf(swarm.head).one}`);
}

const kSamples = 4000;

/** Between which numbers most are: all but a fiftieth below and above; of very many, as a sample of them has it. */
function middleOf(codes: Uint16Array): [number, number] {
  const stride = Math.max(1, Math.floor(codes.length / kSamples));
  const some = new Uint16Array(Math.ceil(codes.length / stride));
  for (let i = 0; i < some.length; ++i) some[i] = codes[i * stride];
  some.sort();
  return [some[Math.floor(0.02 * (some.length - 1))], some[Math.ceil(0.98 * (some.length - 1))]];
}

/** The numbers of the third axis are kept with 16 bits, so they are their own codes. */
function ofHeight(swarm: Swarm): Colouring | null {
  const { head, box } = swarm;
  const { z, start, step } = swarm.kind === 'snapshot' ? swarm.positions : swarm.fixes.positions;
  if (!(box.most[2] > box.least[2]) || !(z instanceof Uint16Array)) return null;
  const least = (box.least[2] - start[2]) / step[2];
  const most = (box.most[2] - start[2]) / step[2];
  const text = (metres: number): string => (head.heights?.in_feet ? `${formatCount(metres / kFoot_m)}\u202fft` : formatTick(Number(metres.toPrecision(3))));
  return {
    by: 'height',
    codes: swarm.kind === 'snapshot' ? z : new Uint16Array(head.count),
    // The highest have the first colour: the lightest one on a dark ground.
    range: [most, least],
    title: head.axes[2] === 'z' ? 'z' : 'Height',
    ends: [text(box.most[2]), text(box.least[2])],
  };
}

const kCodes = 65535;

function speedText(metresPerSecond: number, inKnots: boolean): string {
  return inKnots ? `${formatDigits(metresPerSecond / kKnot_mps, 3)}\u202fkt` : `${formatDigits(metresPerSecond, 2)}\u202fm/s`;
}

/** Makes what is asked for once, and keeps it at the time for bees that move. */
export class Colours {
  readonly offered: ColourBy[];
  readonly #made = new Map<ColourBy, Colouring | null>();
  #most_mps = 1;
  /** Known once the swarm has been seen. */
  company: Company | null = null;

  constructor(
    readonly swarm: Swarm,
    readonly crowding: Crowding | null,
  ) {
    const { kind } = swarm;
    const known: [ColourBy, boolean][] = [
      ['nearest', kind === 'snapshot' ? swarm.nearest !== null : crowding !== null],
      ['height', swarm.box.most[2] > swarm.box.least[2]],
      ['speed', kind === 'recording'],
      ['group', pairsOf(swarm).first.length > 0],
      ['none', true],
    ];
    this.offered = known.filter(([, there]) => there).map(([by]) => by);
  }

  /** Where that is not known, all have one colour. */
  of(wanted: ColourBy): Colouring {
    const { company } = this;
    const by = this.offered.includes(wanted) ? wanted : 'none';
    if (by === 'group' && !company) return kPlain;
    if (!this.#made.has(by)) this.#made.set(by, this.#make(by));
    return this.#made.get(by) ?? kPlain;
  }

  #make(by: ColourBy): Colouring | null {
    const { swarm, company } = this;
    if (by === 'nearest') return ofNearest(swarm, this.crowding);
    if (by === 'height') return ofHeight(swarm);
    if (by === 'speed' && swarm.kind === 'recording') {
      this.#most_mps = speedsOf(swarm.fixes).most_mps || 1;
      const inKnots = swarm.head.heights?.in_feet ?? false;
      const ends: [string, string] = [`≥\u202f${speedText(this.#most_mps, inKnots)}`, speedText(0, inKnots)];
      return { by, codes: new Uint16Array(swarm.head.count), range: [kCodes, 0], title: 'Speed', ends };
    }
    if (by === 'group' && company) {
      const codes = Uint16Array.from(company.groups.of, (place) => (place < 0 ? 0 : 1 + (place % kGroupColours)));
      return { by, codes, range: [0, kGroupColours], title: 'Group of those too close', ends: ['in none', `${formatCount(company.groups.list.length)} groups`] };
    }
    return null;
  }

  /** Of bees that were placed anew. */
  follow({ by, codes }: Colouring, { shown, x, z }: Placement, time_s: number): void {
    const { swarm } = this;
    if (swarm.kind !== 'recording' || !codes) return;
    const count = shown ? shown.length : x.length;
    if (by === 'height') {
      for (let i = 0; i < count; ++i) {
        const bee = shown ? shown[i] : i;
        codes[bee] = z[bee];
      }
    }
    if (by !== 'speed') return;
    const velocity: Triple = [0, 0, 0];
    for (let i = 0; i < count; ++i) {
      const bee = shown ? shown[i] : i;
      const there = swarm.fixes.velocity(bee, time_s, velocity);
      codes[bee] = there ? Math.min(kCodes, (kCodes * Math.hypot(...velocity)) / this.#most_mps) : 0;
    }
  }
}
