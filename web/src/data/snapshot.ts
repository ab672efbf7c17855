// A swarm at one moment.
import { agree, agreeOnPairs } from './agreement';
import { readColumn, readCounts, readMeasures } from './column';
import { readApart, type Apart } from './apart';
import { readNearest, type Nearest } from './nearest';
import { Names } from './names';
import type { SnapshotHead } from './page';
import { boxAround, readPositions, type Box, type Positions } from './positions';

export interface Pairs {
  first: Uint32Array;
  second: Uint32Array;
  distance_m: Float64Array;
  apart: Apart | null;
}

export interface Snapshot {
  kind: 'snapshot';
  head: SnapshotHead;
  names: Names;
  positions: Positions;
  box: Box;
  atRisk: Uint32Array;
  isAtRisk: (bee: number) => boolean;
  nearest: Nearest | null;
  pairs: Pairs;
}

/** The set bits, ascending. */
export function listBits(bits: ArrayLike<number>, count: number): Uint32Array {
  const list: number[] = [];
  for (let byte = 0; byte < bits.length; ++byte) {
    for (let rest = bits[byte]; rest !== 0; rest &= rest - 1) {
      const place = 8 * byte + (31 - Math.clz32(rest & -rest));
      if (place < count) list.push(place);
    }
  }
  return Uint32Array.from(list);
}

/** Names come later, so that the swarm is seen first. */
export async function readSnapshot(head: SnapshotHead): Promise<Snapshot> {
  // All at once: a browser unpacks several side by side.
  const [positions, { raw: bits }, nearest, first, second, distance_m, apart] = await Promise.all([
    readPositions(head.positions),
    readColumn(head.at_risk),
    readNearest(head),
    readCounts(head.pairs.first),
    readCounts(head.pairs.second),
    readMeasures(head.pairs.distance_m),
    readApart(head.pairs),
  ]);
  const pairs: Pairs = { first, second, distance_m, apart };
  agree([positions.x, positions.y, positions.z].every(({ length }) => length === head.count), 'positions');
  agree(bits.length === (head.count + 7) >> 3 && (!nearest || nearest.codes.length === head.count), 'bees');
  agreeOnPairs(pairs, head.count);
  return {
    kind: 'snapshot',
    head,
    names: new Names(null, null),
    positions,
    box: boxAround(positions),
    atRisk: listBits(bits, head.count),
    isAtRisk: (bee) => ((bits[bee >> 3] >> (bee & 7)) & 1) === 1,
    nearest,
    pairs,
  };
}
