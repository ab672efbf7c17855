// What a page holds: swarms at one moment, or moving ones.
import { findGroups, type Groups } from './groups';
import { readNames } from './names';
import { Neighbours } from './neighbours';
import type { Head } from './page';
import { readRecording, type Recording } from './recording';
import { readSnapshot, type Pairs, type Snapshot } from './snapshot';

export type Swarm = Snapshot | Recording;

export function readSwarm(head: Head): Promise<Swarm> {
  return head.kind === 'snapshot' ? readSnapshot(head) : readRecording(head);
}

/** What the panels need beside the swarm itself; made after it is seen. */
export interface Company {
  groups: Groups;
  neighbours: Neighbours;
}

/** Reads the names and finds the groups. */
export async function completeSwarm(swarm: Swarm): Promise<Company> {
  swarm.names = await readNames(swarm.head);
  const { first, second, distance_m } = pairsOf(swarm);
  return {
    groups: findGroups(swarm.head.count, first, second, distance_m),
    neighbours: new Neighbours(swarm.head.count, first, second),
  };
}

/** The pairs that are too close at any time, the closest first; conflicts with a vertical threshold the worst first. */
export function pairsOf(swarm: Swarm): Pairs {
  return swarm.kind === 'snapshot' ? swarm.pairs : swarm.conflicts;
}

/** How far apart a pair of that list is horizontally and in height, where that is known. */
export function apartOf(swarm: Swarm, place: number): { horizontal_m: number; height_m: number } | null {
  const { apart } = pairsOf(swarm);
  return apart && { horizontal_m: apart.horizontal_m[place], height_m: apart.height_m[place] };
}

/** Where a pair stands in the list; of several conflicts the one that covers the time, or is nearest to it. −1: nowhere. */
export function placeOfPair(swarm: Swarm, one: number, other: number, within_s: number): number {
  const { first, second } = pairsOf(swarm);
  const [low, high] = [Math.min(one, other), Math.max(one, other)];
  let best = -1;
  let least = Infinity;
  for (let place = 0; place < first.length; ++place) {
    if (first[place] !== low || second[place] !== high) continue;
    const away =
      swarm.kind === 'snapshot'
        ? 0
        : Math.max(0, swarm.conflicts.begins_s[place] - within_s, within_s - swarm.conflicts.ends_s[place]);
    if (away < least) [best, least] = [place, away];
  }
  return best;
}

/** Bees at risk; of a recording, at any time of it. */
export function beesAtRisk(swarm: Swarm): Uint32Array {
  return swarm.kind === 'snapshot' ? swarm.atRisk : swarm.spans.bees;
}

/** The same bee in the other swarm: of the same name, or of the same number where none has a name. */
export function counterpart(from: Swarm, bee: number, to: Swarm): number | null {
  if (from === to) return bee;
  if (from.names.areNumbers && to.names.areNumbers) return bee < to.head.count ? bee : null;
  return to.names.bee(from.names.of(bee), to.head.count);
}
