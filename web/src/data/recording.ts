// A swarm that moves.
import { agree, agreeOnPairs } from './agreement';
import { readColumn, readCounts, readMeasures } from './column';
import { Fixes } from './fixes';
import { readFleet, type Fleet } from './fleet';
import { readApart, type Apart } from './apart';
import { Names } from './names';
import type { RecordingHead } from './page';
import { readPairWays, type PairWays } from './pair_ways';
import { boxAround, readPositions, type Box } from './positions';
import { Spans } from './spans';

export interface Conflicts {
  first: Uint32Array;
  second: Uint32Array;
  begins_s: Float64Array;
  closest_s: Float64Array;
  ends_s: Float64Array;
  distance_m: Float64Array;
  certain: Uint32Array;
  apart: Apart | null;
}

export interface Separation {
  time_s: Float64Array;
  distance_m: Float64Array;
  first: Uint32Array;
  second: Uint32Array;
  /** With a vertical threshold: of those who are nearest to a conflict. */
  apart: Apart | null;
  /** When it is not known, as one may be closer in its gap; ascending. */
  open: { begins_s: Float64Array; ends_s: Float64Array };
}

export interface Recording {
  kind: 'recording';
  head: RecordingHead;
  names: Names;
  box: Box;
  fixes: Fixes;
  conflicts: Conflicts;
  spans: Spans;
  /** When bees are there, and it is not known where. */
  unknown: Spans;
  separation: Separation;
  pairWays: PairWays;
  fleet: Fleet | null;
}

async function readConflicts(places: RecordingHead['conflicts']): Promise<Conflicts> {
  return {
    first: await readCounts(places.first),
    second: await readCounts(places.second),
    begins_s: await readMeasures(places.begins_s),
    closest_s: await readMeasures(places.closest_s),
    ends_s: await readMeasures(places.ends_s),
    distance_m: await readMeasures(places.distance_m),
    certain: await readCounts(places.certain),
    apart: await readApart(places),
  };
}

async function readSpans(places: RecordingHead['at_risk'] | undefined): Promise<Spans> {
  const none = new Float64Array(0);
  if (!places) return new Spans(new Uint32Array(0), none, none);
  return new Spans(await readCounts(places.bee), await readMeasures(places.begins_s), await readMeasures(places.ends_s));
}

async function readSeparation(places: RecordingHead['separation']): Promise<Separation> {
  const none = new Float64Array(0);
  const { open } = places;
  return {
    time_s: await readMeasures(places.time_s),
    distance_m: await readMeasures(places.distance_m),
    first: await readCounts(places.first),
    second: await readCounts(places.second),
    apart: await readApart(places),
    open: open ? { begins_s: await readMeasures(open.begins_s), ends_s: await readMeasures(open.ends_s) } : { begins_s: none, ends_s: none },
  };
}

export async function readRecording(head: RecordingHead): Promise<Recording> {
  const positions = await readPositions(head.fixes);
  const time = await readColumn(head.fixes.time_s);
  const counts = await readCounts(head.fixes.counts);
  const conflicts = await readConflicts(head.conflicts);
  const fixes = counts.reduce((sum, count) => sum + count, 0);
  agree(counts.length === head.count, 'bees');
  agree([time.raw, positions.x, positions.y, positions.z].every(({ length }) => length === fixes), 'fixes');
  agreeOnPairs(conflicts, head.count);
  return {
    kind: 'recording',
    head,
    names: new Names(null, null),
    box: boxAround(positions),
    fixes: new Fixes(counts, time, positions, await readCounts(head.absent_after)),
    conflicts,
    spans: await readSpans(head.at_risk),
    unknown: await readSpans(head.unknown),
    separation: await readSeparation(head.separation),
    pairWays: await readPairWays(head.pair_ways, head.vertical_m !== undefined),
    fleet: head.fleet ? await readFleet(head.fleet) : null,
  };
}

/** Places of the conflicts that cover the time. */
export function conflictsAt(conflicts: Conflicts, time_s: number): number[] {
  const found: number[] = [];
  for (let place = 0; place < conflicts.first.length; ++place) {
    if (conflicts.begins_s[place] <= time_s && time_s <= conflicts.ends_s[place]) found.push(place);
  }
  return found;
}

/** The sample of the separation at or before the time, or the first; −1 where there are none. */
export function sampleAt(times: Float64Array, time_s: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time_s) low = middle + 1;
    else high = middle;
  }
  return times.length === 0 ? -1 : Math.max(0, low - 1);
}
