// One clock for one or two recordings.
import type { RecordingTime } from '../data/page';
import type { Swarm } from '../data/swarm';
import type { Recording } from '../data/recording';
import { areAlike, joined, kSeconds, zeroOf, type Calendar } from '../text/calendar';
import { Clock } from './clock';
import { longestOpen } from './unknown';

export interface LinkedTimes {
  clock: Clock;
  /** What the clock's time is called: added to it. */
  zero_s: number;
  /** How that is told. */
  calendar: Calendar;
  /** The clock's time as seconds from the beginning of this swarm. */
  within: (of: { swarm: Swarm }) => number;
  /** The other way round. */
  clockTime: (of: { swarm: Swarm }, within_s: number) => number;
  /** Rests at this many seconds from the beginning of a swarm. */
  seek: (of: { swarm: Swarm }, within_s: number) => void;
  /** How they were laid beside each other, where that must be said. */
  note: string | null;
}

function isRecording(swarm: Swarm): swarm is Recording {
  return swarm.kind === 'recording';
}

/** Recordings of the same hours keep their times; others begin together. */
export function linkTimes(swarms: Swarm[]): LinkedTimes {
  const recordings = swarms.filter(isRecording);
  const times = recordings.map(({ head }) => head.time);
  if (times.length === 0) {
    return {
      clock: new Clock(0, 0, 1),
      zero_s: 0,
      calendar: kSeconds,
      within: () => 0,
      clockTime: () => 0,
      seek: () => undefined,
      note: null,
    };
  }
  const [one, other = one] = times;
  // As the first one counts.
  const begins = (time: RecordingTime): number => time.begins_s + zeroOf(time) - zeroOf(one);
  const ends_s = begins(other) + other.ends_s - other.begins_s;
  const overlap = areAlike(one, other) && one.begins_s <= ends_s && begins(other) <= one.ends_s;
  const zero = overlap ? Math.min(one.begins_s, begins(other)) : 0;
  const shift = (swarm: Swarm): number => (overlap && isRecording(swarm) ? begins(swarm.head.time) - zero : 0);
  const ends = Math.max(...recordings.map((swarm) => shift(swarm) + swarm.head.time.ends_s - swarm.head.time.begins_s));
  const clock = new Clock(0, ends, stepOf(recordings[0], ends));
  return {
    clock,
    zero_s: overlap ? zero : 0,
    calendar: overlap ? joined(one, other) : kSeconds,
    within: ({ swarm }) => clock.time.value - shift(swarm),
    clockTime: ({ swarm }, within_s) => within_s + shift(swarm),
    seek: ({ swarm }, within_s) => {
      clock.pause();
      clock.go(within_s + shift(swarm));
    },
    note: overlap ? null : 'The two recordings are of different times; both are shown from their beginning on.',
  };
}

/**
 * A page opens at the worst moment of the first recording that has one: at one glance, which bees, where and when. Where none
 * has a conflict, where one may be hidden.
 */
export function showWorstMoment(swarms: Swarm[], times: LinkedTimes): void {
  const recordings = swarms.filter(isRecording);
  const worst = recordings.find(({ conflicts }) => conflicts.closest_s.length > 0);
  if (worst) return times.clock.showPoster(times.clockTime({ swarm: worst }, worst.conflicts.closest_s[0]));
  for (const swarm of recordings) {
    const within_s = longestOpen(swarm.separation);
    if (within_s !== null) return times.clock.showPoster(times.clockTime({ swarm }, within_s));
  }
}

/** About a fix at a time, and the whole in no more than a thousand steps. */
function stepOf(recording: Recording, ends_s: number): number {
  const { fixes } = recording;
  const counts = Array.from({ length: Math.min(64, fixes.bees) }, (_, bee) => fixes.countOf(bee));
  const most = Math.max(2, ...counts);
  const between = ends_s / (most - 1);
  return Math.max(between, ends_s / 1000) || 1;
}
