// What the reader looks at, in the address of the page: after the #, so that it stays on the reader's machine.
import type { Signal } from './signal';
import { kColourings, type Choices, type ColourBy } from './choices';

export interface Address {
  /** The clock's time. */
  time_s: number | null;
  swarm: number;
  /** A bee, or two. */
  bees: number[];
  /** Camera: its place, what it looks at, in metres of the axes, and how wide it sees, in degrees. */
  camera: number[] | null;
  atRiskOnly: boolean;
  group: { swarm: number; place: number } | null;
  /** Null: as the page shows them by itself. */
  trails: boolean | null;
  vectors: boolean;
  colourBy: ColourBy;
  lift: number | null;
}

const kPlain: Address = {
  time_s: null,
  swarm: 0,
  bees: [],
  camera: null,
  atRiskOnly: false,
  group: null,
  trails: null,
  vectors: false,
  colourBy: 'nearest',
  lift: null,
};

function numbersOf(text: string | null, counts: number[]): number[] | null {
  if (text === null) return null;
  const numbers = text.split(',').map((one) => (one.trim() === '' ? NaN : Number(one)));
  return counts.includes(numbers.length) && numbers.every(Number.isFinite) ? numbers : null;
}

const isPlace = (number: number): boolean => Number.isSafeInteger(number) && number >= 0;

/** What cannot be read is as if it were not there: an address may be cut. */
export function readAddress(hash: string): Address {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const [time_s = null] = numbersOf(given.get('t'), [1]) ?? [];
  const [swarm = 0] = numbersOf(given.get('swarm'), [1]) ?? [];
  const bees = numbersOf(given.get('bees'), [1, 2]) ?? [];
  const group = numbersOf(given.get('group'), [2]);
  const [lift = null] = numbersOf(given.get('heights'), [1]) ?? [];
  return {
    time_s,
    swarm: isPlace(swarm) ? swarm : 0,
    bees: bees.every(isPlace) ? bees : [],
    camera: numbersOf(given.get('camera'), [7]),
    atRiskOnly: given.get('only') === 'risk',
    group: group && group.every(isPlace) ? { swarm: group[0], place: group[1] } : null,
    trails: given.has('trails') ? given.get('trails') === '1' : null,
    vectors: given.get('vectors') === '1',
    colourBy: kColourings.find((one) => one === given.get('colour')) ?? 'nearest',
    lift: lift !== null && lift >= 1 ? lift : null,
  };
}

/** The shortest that says it; empty where there is nothing to say. */
export function writeAddress(address: Partial<Address>): string {
  const { time_s, swarm, bees, camera, atRiskOnly, group, trails, vectors, colourBy, lift } = { ...kPlain, ...address };
  const parts = [
    time_s === null ? '' : `t=${Number(time_s.toFixed(3))}`,
    bees.length > 0 && swarm > 0 ? `swarm=${swarm}` : '',
    bees.length > 0 ? `bees=${bees.join(',')}` : '',
    group ? `group=${group.swarm},${group.place}` : '',
    atRiskOnly ? 'only=risk' : '',
    trails === null ? '' : `trails=${trails ? 1 : 0}`,
    vectors ? 'vectors=1' : '',
    colourBy === 'nearest' ? '' : `colour=${colourBy}`,
    lift === null ? '' : `heights=${lift}`,
    camera ? `camera=${camera.map((number) => Number(number.toPrecision(8))).join(',')}` : '',
  ].filter((part) => part !== '');
  return parts.length > 0 ? `#${parts.join('&')}` : '';
}

export interface Seen {
  choices: Choices;
  time: Signal<number> | null;
  playing: Signal<boolean> | null;
  camera: () => number[] | null;
  /** Heights are drawn so many times larger unless the reader wants it otherwise. */
  usualLift: number;
  usualTrails: boolean;
}

export function addressNow({ choices, time, camera, usualLift, usualTrails }: Seen): string {
  const selected = choices.selected.value;
  const { atRiskOnly, group } = choices.filter.value;
  return writeAddress({
    time_s: time?.value ?? null,
    swarm: selected?.swarm ?? 0,
    bees: selected ? [selected.bee, selected.other].filter((bee) => bee !== null) : [],
    camera: camera(),
    atRiskOnly,
    group,
    trails: choices.trails.value === usualTrails ? null : choices.trails.value,
    vectors: choices.vectors.value,
    colourBy: choices.colourBy.value,
    lift: choices.lift.value === usualLift ? null : choices.lift.value,
  });
}

const kRest_ms = 300;

/** Keeps the address at what is seen, whenever that rests; the address of a page that was only opened stays as it was. */
export function keepAddress(seen: Seen, onCamera: (listener: () => void) => void): void {
  let waiting = 0;
  let touched = false;
  for (const kind of ['pointerdown', 'keydown', 'wheel'] as const) {
    addEventListener(kind, () => (touched = true), { capture: true, passive: true, once: true });
  }
  const changed = (): void => {
    clearTimeout(waiting);
    if (!touched) return;
    waiting = window.setTimeout(() => {
      if (seen.playing?.value) return changed();
      try {
        history.replaceState(null, '', addressNow(seen) || '#');
      } catch {
        // Where a page may not change its address, "Copy link" still knows it.
      }
    }, kRest_ms);
  };
  const { choices, time } = seen;
  for (const listen of [choices.selected, choices.filter, choices.trails, choices.vectors, choices.colourBy, choices.lift, ...(time ? [time] : [])]) {
    (listen as Signal<unknown>).listen(changed);
  }
  onCamera(changed);
}

/** Copies a text; false where the browser does not let us. */
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
