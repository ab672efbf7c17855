// Which bees are drawn where, right now: what the views draw, after the reader's filter.
import { conflictsAt, type Recording } from '../data/recording';
import type { Numbers } from '../data/column';
import { Crowding } from './crowding';
import type { Triple } from '../data/positions';
import type { Snapshot } from '../data/snapshot';
import { beesAtRisk, type Company } from '../data/swarm';

export interface Placement {
  x: Numbers | Float32Array;
  y: Numbers | Float32Array;
  z: Numbers | Float32Array;
  start: Triple;
  step: Triple;
  /** Bees that are there and shown; null: all. */
  shown: Uint32Array | null;
  /** Of these, the ones at risk. */
  atRisk: Uint32Array;
  /** Bees to draw a line between, two by two. */
  lines: Uint32Array;
}

export function placeIn({ x, y, z, start, step }: Placement, bee: number): Triple {
  return [start[0] + step[0] * x[bee], start[1] + step[1] * y[bee], start[2] + step[2] * z[bee]];
}

export interface Wanted {
  atRiskOnly: boolean;
  group: number | null;
}

function membersOf(company: Company, group: number): Uint32Array {
  return Uint32Array.from(company.groups.list[group]?.bees ?? []);
}

export function placeSnapshot(swarm: Snapshot, company: Company | null, wanted: Wanted): Placement {
  const { pairs } = swarm;
  const group = company && wanted.group !== null ? wanted.group : null;
  const members = company && group !== null ? membersOf(company, group) : null;
  const lines = new Uint32Array(2 * pairs.first.length);
  let ends = 0;
  for (let i = 0; i < pairs.first.length; ++i) {
    if (company && group !== null && company.groups.of[pairs.first[i]] !== group) continue;
    lines[ends++] = pairs.first[i];
    lines[ends++] = pairs.second[i];
  }
  return {
    ...swarm.positions,
    shown: members ?? (wanted.atRiskOnly ? swarm.atRisk : null),
    atRisk: members ? members.filter(swarm.isAtRisk) : swarm.atRisk,
    lines: lines.subarray(0, ends),
  };
}

/** Places a recording at one moment after the other, into the same arrays. */
export class RecordingPlacer {
  readonly crowding: Crowding | null;
  readonly #arrays: Record<'x' | 'y' | 'z', Float32Array>;
  readonly #there: Uint8Array;

  constructor(readonly swarm: Recording) {
    const { count, threshold_m } = swarm.head;
    this.crowding = Crowding.for(count, threshold_m);
    this.#arrays = { x: new Float32Array(count), y: new Float32Array(count), z: new Float32Array(count) };
    this.#there = new Uint8Array(count);
  }

  /** Of a crowd that moves, one of `every` bees is placed, and all that are in conflict now or `watched`. */
  at(time_s: number, company: Company | null, wanted: Wanted, every = 1, watched: number[] = []): Placement {
    const { swarm } = this;
    const { x, y, z } = this.#arrays;
    const { start, step } = swarm.fixes.positions;
    const risky = swarm.spans.beesAt(time_s);
    const present = every > 1 ? this.#placeSome(time_s, every, [...risky, ...watched]) : this.#placeAll(time_s);
    this.crowding?.measure(present, x, y, z, step);
    const shown = this.#chosen(present, company, wanted);
    const lines: number[] = [];
    for (const place of conflictsAt(swarm.conflicts, time_s)) {
      const first = swarm.conflicts.first[place];
      const second = swarm.conflicts.second[place];
      if (this.#there[first] && this.#there[second]) lines.push(first, second);
    }
    const atRisk = Uint32Array.from(risky.filter((bee) => this.#there[bee] === 1));
    return { x, y, z, start, step, shown, atRisk, lines: Uint32Array.from(lines) };
  }

  #placeAll(time_s: number): Uint32Array {
    const { count } = this.swarm.head;
    const { x, y, z } = this.#arrays;
    const present = new Uint32Array(count);
    let there = 0;
    for (let bee = 0; bee < count; ++bee) {
      const isThere = this.swarm.fixes.place(bee, time_s, x, y, z, bee);
      this.#there[bee] = isThere ? 1 : 0;
      if (isThere) present[there++] = bee;
    }
    return present.subarray(0, there);
  }

  #placeSome(time_s: number, every: number, wanted: number[]): Uint32Array {
    const { count } = this.swarm.head;
    const { x, y, z } = this.#arrays;
    const present = new Uint32Array(Math.ceil(count / every) + wanted.length);
    let there = 0;
    this.#there.fill(0);
    const place = (bee: number): void => {
      if (this.#there[bee] === 1 || !this.swarm.fixes.place(bee, time_s, x, y, z, bee)) return;
      this.#there[bee] = 1;
      present[there++] = bee;
    };
    for (let bee = 0; bee < count; bee += every) place(bee);
    for (const bee of wanted) place(bee);
    return present.subarray(0, there);
  }

  /** Of the bees that are there, those that the reader wants to see; the others count as not there. */
  #chosen(present: Uint32Array, company: Company | null, { group, atRiskOnly }: Wanted): Uint32Array {
    const some =
      company && group !== null ? membersOf(company, group) : atRiskOnly ? beesAtRisk(this.swarm) : null;
    if (!some) return present;
    const shown = some.filter((bee) => this.#there[bee] === 1);
    this.#there.fill(0);
    for (const bee of shown) this.#there[bee] = 1;
    return shown;
  }
}
