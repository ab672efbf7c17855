// The page's own data: one JSON object that says where the columns are.
import { adler32 } from './checksum';
import type { ColumnPlace } from './column';
import type { Triple } from './positions';

export interface Origin {
  longitude_deg: number;
  latitude_deg: number;
  height_m: number;
}

/** How those who made the input speak of heights; absent: in metres, not by pressure. */
export interface HeightWords {
  in_feet: boolean;
  by_pressure: boolean;
}

/** What is recorded, as people call it. */
export interface Noun {
  one: string;
  several: string;
}

/** How far apart two are horizontally and in height. */
export interface ApartHead {
  horizontal_m?: number;
  height_m?: number;
}

export interface ClosestPair extends ApartHead {
  first: number;
  second: number;
  distance_m: number;
}

export interface SnapshotRisk {
  at_risk: number;
  pairs: number;
  groups: number;
  largest_group: number;
  unknown?: string;
  /** What comes after the moment, if all fly straight on. */
  ahead?: string;
  ahead_count?: number;
  closest?: ClosestPair;
}

export interface RecordingRisk {
  conflicts: number;
  possible: number;
  pairs: number;
  bees: number;
  bee_seconds: number;
  /** Beside the conflicts: "72 conflicts of two lower than 3 m above where they took off". */
  left_out?: string;
  unknown?: string;
  /** Beside those of `count`: how many are known at no time. */
  nowhere?: number;
  /** No two are there at the same time. */
  nothing_compared?: boolean;
  /** `stands`: one of the two is a drone of a show that stands on the ground. */
  closest?: ClosestEncounter & { stands?: boolean };
  /** Beside such a one: of two in the air. */
  closest_in_the_air?: ClosestEncounter;
}

export type ClosestEncounter = ClosestPair & { time_s: number };

type Places<Names extends string> = Record<Names, ColumnPlace>;

/** Both or none. */
export type ApartPlaces = Partial<Places<'horizontal_m' | 'height_m'>>;

export type PairWaysHead = Places<'counts' | 'time_s' | 'x' | 'y' | 'z'> &
  Partial<Places<'ground_x' | 'ground_y' | 'ground_z' | 'height'>>;

/** What stands in the way, in metres of the axes; without heights it has no end there. */
export type Obstacle =
  | { kind: 'sphere'; center: Triple; radius_m: number }
  | { kind: 'box'; low: Triple; high: Triple }
  | { kind: 'ground'; height_m: number }
  | { kind: 'cylinder'; center: [number, number]; radius_m: number; low_m?: number; high_m?: number }
  | { kind: 'prism'; outline: [number, number][]; low_m?: number; high_m?: number };

/** How the limits that a drone show declares are kept along its curves, as the engine has found. */
export interface LimitsKept {
  /** Of all excesses; of many the worst are here. */
  count: number;
  greatest: { limit: LimitName; most: number; value: number; bee: number; time_s: number }[];
  /** Of `greatest[limit]`, the worst first. */
  excesses: { limit: number; bee: number; begins_s: number; ends_s: number; value: number; time_s: number }[];
  /** Names of limits that the show declares beside these, if any. */
  not_looked_at?: string[];
}
export type LimitName = 'horizontal' | 'climb' | 'descent' | 'height' | 'acceleration' | 'horizontal_acceleration' | 'vertical_acceleration';

export interface Cue {
  time_s: number;
  name: string;
}

interface SwarmHead {
  title: string;
  source: string;
  count: number;
  axes: [string, string, string];
  origin?: Origin;
  heights?: HeightWords;
  /** The input, or who asked, speaks of nautical miles or feet: separations are told in them, too. */
  aviation?: boolean;
  /** Absent: bees. */
  noun?: Noun;
  /** y counts downwards, as in a picture. */
  y_down?: boolean;
  /** The input has no heights: the third coordinate is 0 and means nothing. */
  flat?: boolean;
  threshold_m: number;
  vertical_m?: number;
  inclusive: boolean;
  /** `called`: of bees with several names one after the other, since when they are called each. */
  names?: { texts: ColumnPlace; bees?: ColumnPlace; called?: { bees: ColumnPlace; since_s: ColumnPlace; texts: ColumnPlace } };
  position_error_m: number;
  notes: string[];
  obstacles?: Obstacle[];
}

export interface SnapshotHead extends SwarmHead {
  kind: 'snapshot';
  /** When it is, where the input says so. */
  moment?: string;
  risk: SnapshotRisk;
  positions: Places<'x' | 'y' | 'z'>;
  at_risk: ColumnPlace;
  nearest?: { code: ColumnPlace; least_m: number; ratio: number };
  pairs: Places<'first' | 'second' | 'distance_m'> & ApartPlaces;
}

/** What the planner of the fleet said of each bee. */
export interface FleetHead {
  title: string;
  tick_s: number;
  states: Places<
    | 'counts'
    | 'time_s'
    | 'x'
    | 'y'
    | 'z'
    | 'absent_after'
    | 'tube_m'
    | 'contract'
    | 'reason'
    | 'certified'
    | 'branches'
    | 'newest'
  >;
  branches: Places<'counts' | 'time_s' | 'x' | 'y' | 'z' | 'braking_s' | 'back'> & { stop: Places<'x' | 'y' | 'z'> };
}

/** What a clock shows that is not that of UTC. */
export interface ClockHead {
  /** Whether its day is known. */
  dated: boolean;
  /** Absent: the input names none. */
  zone?: string;
  /** From then on (from the beginning of the recording) it is so far ahead of the numbers. */
  offsets: { from_s: number; ahead_s: number }[];
}

export interface RecordingTime {
  begins_s: number;
  ends_s: number;
  since_1970: boolean;
  /** Absent: times are told in UTC, or as seconds. */
  clock?: ClockHead;
}

export interface RecordingHead extends SwarmHead {
  kind: 'recording';
  risk: RecordingRisk;
  time: RecordingTime;
  fixes: Places<'counts' | 'time_s' | 'x' | 'y' | 'z'>;
  absent_after: ColumnPlace;
  conflicts: Places<
    'first' | 'second' | 'begins_s' | 'closest_s' | 'ends_s' | 'distance_m' | 'certain'
  > &
    ApartPlaces;
  pair_ways: PairWaysHead;
  at_risk: Places<'bee' | 'begins_s' | 'ends_s'>;
  /** When bees are there, and it is not known where; absent: never. */
  unknown?: Places<'bee' | 'begins_s' | 'ends_s'>;
  separation: Places<'time_s' | 'distance_m' | 'first' | 'second'> & ApartPlaces & { open?: Places<'begins_s' | 'ends_s'> };
  fleet?: FleetHead;
  limits_kept?: LimitsKept;
  cues?: Cue[];
}

export type Head = SnapshotHead | RecordingHead;

export interface Page {
  beespace: string;
  /** Whether it has coasts and borders. */
  ground?: boolean;
  swarms: Head[];
}

/** What a swarm is drawn with. */
export type EarlyHead = Pick<Head, 'count' | 'kind'>;

/** The same of each swarm as soon as the page's head is there, before the columns are; null where it is not, or is damaged. */
export async function headsOf(): Promise<EarlyHead[] | null> {
  const holder = await arrived('beespace-page');
  try {
    return holder && (JSON.parse(holder.textContent ?? '') as Page).swarms.map(({ count, kind }) => ({ count, kind }));
  } catch {
    return null;
  }
}

/** An element, once the browser has read all of it; null where the page has none. */
function arrived(id: string): Promise<HTMLElement | null> {
  const whole = (): HTMLElement | null => {
    const one = document.getElementById(id);
    return one?.nextElementSibling || document.readyState !== 'loading' ? one : null;
  };
  const there = whole();
  if (there || document.readyState !== 'loading') return Promise.resolve(there);
  return new Promise((resolve) => {
    const look = (): void => {
      const one = whole();
      if (!one && document.readyState === 'loading') return;
      watch.disconnect();
      document.removeEventListener('DOMContentLoaded', look);
      resolve(one);
    };
    const watch = new MutationObserver(look);
    watch.observe(document.body, { childList: true });
    document.addEventListener('DOMContentLoaded', look);
  });
}

/** Nothing where no data were put into the page. */
export function readPage(): Page | null {
  const holder = document.getElementById('beespace-page');
  if (!holder) return null;
  const end = document.getElementById('beespace-end');
  if (!end) throw new Error('it is cut off');
  const text = holder.textContent ?? '';
  const [sum, columns] = (end.textContent ?? '').split(' ');
  if (parseInt(sum, 16) !== adler32(new TextEncoder().encode(text))) throw new Error('what it says of the swarm was changed');
  // Beside the columns there are the program and the end, and perhaps the ground.
  if (document.querySelectorAll('script[id^="beespace-"][type="text/plain"]:not(#beespace-ground)').length !== Number(columns) + 2) {
    throw new Error('columns of it are missing');
  }
  const page = JSON.parse(text) as Page & { format: number };
  if (page.format !== 1) throw new Error(`format ${page.format} of the data is not known to this page`);
  return page;
}
