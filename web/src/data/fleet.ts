// What the planner of a fleet said of each bee: where it shall be, how far from there it can be, whether it keeps
// its contract, and on which branches it may be. See docs/page-format.md.
import { readColumn, readCounts, readMeasures } from './column';
import { Fixes } from './fixes';
import type { FleetHead } from './page';
import { positionOf, readPositions, type Positions, type Triple } from './positions';

export const kContracts = ['kept', 'doubted', 'out'] as const;
export type Contract = (typeof kContracts)[number];

/** Why a contract is broken, by the numbers of the format. */
const kReasons = [
  '',
  'too far from its nominal place',
  'drifts off faster than it may',
  'not heard of',
  'has lost its branch',
  'reports from the future',
];

/** Why it is doubted: only what is known is said. */
function reasonOf(contract: Contract, reason: number): string {
  return contract === 'doubted' && reason === 1 ? 'perhaps too far from its nominal place' : (kReasons[reason] ?? '');
}

export interface Told {
  contract: Contract;
  reason: string;
  certified: boolean;
  tube_m: number;
  branches: number;
}

/** Where the planner may have a bee from now on. */
export interface Claim {
  /** The path of the newest branch: from now to its stop. */
  path: Triple[];
  /** Ends of older branches: from where they leave the path to their stops; of one that has begun, from now on. */
  sides: { from: Triple; stop: Triple; begun: boolean }[];
}

/** When a bee was first out of its contract, and why. */
export interface Outcast {
  bee: number;
  time_s: number;
  reason: string;
}

interface Branches {
  from: Uint32Array;
  time_s: Float64Array;
  places: Positions;
  stops: Positions;
  braking_s: Float64Array;
  back: Uint32Array;
}

interface States {
  tube_m: Float64Array;
  contract: Uint32Array;
  reason: Uint32Array;
  certified: Uint32Array;
  branches: Uint32Array;
  newest: Uint32Array;
}

function sums(counts: Uint32Array): Uint32Array {
  const from = new Uint32Array(counts.length + 1);
  for (let i = 0; i < counts.length; ++i) from[i + 1] = from[i] + counts[i];
  return from;
}

export class Fleet {
  /** The first to be out first. */
  readonly outcasts: Outcast[];
  /** How many bees were doubted at some time; of how many anything is said. */
  readonly doubted: number;
  readonly known: number;

  constructor(
    readonly title: string,
    readonly places: Fixes,
    readonly states: States,
    readonly branches: Branches,
  ) {
    const bees = Array.from({ length: places.bees }, (_, bee) => bee);
    this.outcasts = bees
      .flatMap((bee) => this.#first(bee, 'out') ?? [])
      .sort((a, b) => a.time_s - b.time_s || a.bee - b.bee);
    this.doubted = bees.filter((bee) => this.#first(bee, 'doubted') !== null).length;
    this.known = bees.filter((bee) => places.countOf(bee) > 0).length;
  }

  /** Where the planner has the bee at the time; null where it says nothing of it. */
  ghost(bee: number, time_s: number): Triple | null {
    const [x, y, z] = [new Float32Array(1), new Float32Array(1), new Float32Array(1)];
    if (!this.places.place(bee, time_s, x, y, z, 0)) return null;
    const { start, step } = this.places.positions;
    return [start[0] + step[0] * x[0], start[1] + step[1] * y[0], start[2] + step[2] * z[0]];
  }

  told(bee: number, time_s: number): Told | null {
    const state = this.#stateAt(bee, time_s);
    if (state === null) return null;
    const { contract, reason, certified, tube_m, branches } = this.states;
    const kind = kContracts[contract[state]] ?? 'kept';
    return {
      contract: kind,
      reason: reasonOf(kind, reason[state]),
      certified: certified[state] === 1,
      tube_m: tube_m[state],
      branches: branches[state],
    };
  }

  contractAt(bee: number, time_s: number): Contract | null {
    const state = this.#stateAt(bee, time_s);
    return state === null ? null : (kContracts[this.states.contract[state]] ?? 'kept');
  }

  /** Null where no branch is known. */
  claim(bee: number, time_s: number): Claim | null {
    const state = this.#stateAt(bee, time_s);
    const ghost = this.ghost(bee, time_s);
    if (state === null || ghost === null || this.states.newest[state] === 0) return null;
    const { from, time_s: at_s, places, stops, back } = this.branches;
    const newest = from[bee] + this.states.newest[state] - 1;
    const path: Triple[] = [positionOf(stops, newest)];
    const sides: Claim['sides'] = [];
    let live = this.states.branches[state];
    for (let branch = newest; live > 0 || at_s[branch] > time_s; --live) {
      if (at_s[branch] > time_s) path.push(positionOf(places, branch));
      if (live > 0 && branch !== newest) {
        sides.push({ from: this.#begin(branch, time_s), stop: positionOf(stops, branch), begun: at_s[branch] <= time_s });
      }
      if (back[branch] === 0) break;
      branch -= back[branch];
    }
    path.push(ghost);
    return { path: path.reverse(), sides };
  }

  /** How far a place is from the nearest at which the planner may have the bee at the time. */
  deviation(bee: number, time_s: number, place: Triple): number | null {
    const ghost = this.ghost(bee, time_s);
    if (ghost === null) return null;
    const apart = (at: Triple): number => Math.hypot(...at.map((one, axis) => one - place[axis]));
    const sides = this.claim(bee, time_s)?.sides ?? [];
    return Math.min(apart(ghost), ...sides.map(({ from, begun }) => (begun ? apart(from) : Infinity)));
  }

  /** Where the bee is on the end of a branch that is its own, or will be first. */
  #begin(branch: number, time_s: number): Triple {
    const { time_s: at_s, places, stops, braking_s } = this.branches;
    const place = positionOf(places, branch);
    if (at_s[branch] >= time_s || braking_s[branch] === 0) return place;
    const left = Math.max(0, 1 - (time_s - at_s[branch]) / braking_s[branch]);
    const stop = positionOf(stops, branch);
    const mix = (axis: 0 | 1 | 2): number => stop[axis] + left * left * (place[axis] - stop[axis]);
    return [mix(0), mix(1), mix(2)];
  }

  #stateAt(bee: number, time_s: number): number | null {
    return this.places.isThere(bee, time_s) ? Math.max(this.places.fixAt(bee, time_s), this.places.firstOf(bee)) : null;
  }

  /** The first state of the bee in which its contract is so. */
  #first(bee: number, contract: Contract): Outcast | null {
    const code = kContracts.indexOf(contract);
    const first = this.places.firstOf(bee);
    const at = this.states.contract.subarray(first, first + this.places.countOf(bee)).indexOf(code);
    if (at < 0) return null;
    return { bee, time_s: this.places.timeOf(first + at), reason: reasonOf(contract, this.states.reason[first + at]) };
  }
}

export async function readFleet({ title, states, branches }: FleetHead): Promise<Fleet> {
  const places = new Fixes(
    await readCounts(states.counts),
    await readColumn(states.time_s),
    await readPositions(states),
    await readCounts(states.absent_after),
  );
  return new Fleet(
    title,
    places,
    {
      tube_m: await readMeasures(states.tube_m),
      contract: await readCounts(states.contract),
      reason: await readCounts(states.reason),
      certified: await readCounts(states.certified),
      branches: await readCounts(states.branches),
      newest: await readCounts(states.newest),
    },
    {
      from: sums(await readCounts(branches.counts)),
      time_s: await readMeasures(branches.time_s),
      places: await readPositions(branches),
      stops: await readPositions(branches.stop),
      braking_s: await readMeasures(branches.braking_s),
      back: await readCounts(branches.back),
    },
  );
}
