// Swarms at one moment, as the command would write them.
import { findGroups } from '../../src/data/groups';
import type { SnapshotHead } from '../../src/data/page';
import { Elements } from './encode';
import { findNear, type Points } from './neighbourhood';
import { randomFrom } from './random';

export interface SnapshotWish {
  count: number;
  size_m: number;
  threshold_m: number;
  vertical_m?: number;
  seed: number;
  title?: string;
  names?: string[];
  notes?: string[];
  mostPairs?: number;
  noRisk?: boolean;
  geographic?: boolean;
}

function scatter({ count, size_m, seed }: SnapshotWish): Points {
  const random = randomFrom(seed);
  const points = { x: new Float64Array(count), y: new Float64Array(count), z: new Float64Array(count) };
  const centres = Array.from({ length: 7 }, () => [random(), random(), random()]);
  for (let i = 0; i < count; ++i) {
    const centre = centres[i % centres.length];
    const loose = i % 3 === 0 ? 1 : 0.45;
    const bell = (): number => (random() + random() + random() - 1.5) / 1.5;
    points.x[i] = size_m * (centre[0] + 0.5 * loose * bell());
    points.y[i] = size_m * (centre[1] + 0.5 * loose * bell());
    points.z[i] = 0.25 * size_m * (centre[2] + 0.5 * loose * bell());
  }
  return points;
}

export function snapshotHead(elements: Elements, wish: SnapshotWish): SnapshotHead {
  const points = scatter(wish);
  const { count } = wish;
  const spacing = wish.size_m / Math.cbrt(count);
  const found = findNear(points, wish.threshold_m, (count > 50000 ? 0.4 : 0.9) * spacing);
  const pairs = wish.noRisk ? [] : found.pairs;
  const bits = new Uint8Array((count + 7) >> 3);
  let atRisk = 0;
  for (const { first, second } of pairs) {
    for (const bee of [first, second]) {
      if (((bits[bee >> 3] >> (bee & 7)) & 1) === 0) ++atRisk;
      bits[bee >> 3] |= 1 << (bee & 7);
    }
  }
  const least = found.nearest_m.reduce((a, b) => Math.min(a, b));
  const most = found.nearest_m.reduce((a, b) => Math.max(a, b));
  const ratio = Math.max(1 + 1e-9, (most / least) ** (1 / 65534));
  const codes = Uint16Array.from(found.nearest_m, (d) =>
    d === 0 ? 0 : Math.min(65535, 1 + Math.round(Math.log(d / least) / Math.log(ratio))),
  );
  const all = findGroups(
    count,
    Uint32Array.from(pairs, (pair) => pair.first),
    Uint32Array.from(pairs, (pair) => pair.second),
    Float64Array.from(pairs, (pair) => pair.distance_m),
  );
  const listed = pairs.slice(0, wish.mostPairs ?? 200000);
  const [closest] = found.pairs;
  return {
    kind: 'snapshot',
    title: wish.title ?? `bees-${count}.csv`,
    source: `${wish.title ?? `bees-${count}.csv`}, text, comma-separated`,
    count,
    axes: wish.geographic ? ['east', 'north', 'up'] : ['x', 'y', 'z'],
    ...(wish.geographic && { origin: { longitude_deg: -75.5812, latitude_deg: 6.2442, height_m: 1495 } }),
    threshold_m: wish.threshold_m,
    ...(wish.vertical_m !== undefined && { vertical_m: wish.vertical_m }),
    inclusive: false,
    ...(wish.names && { names: { texts: elements.texts(wish.names) } }),
    position_error_m: (wish.size_m * 2) / 65535 / 2,
    notes: wish.notes ?? [],
    risk: {
      at_risk: atRisk,
      pairs: pairs.length,
      groups: all.list.length,
      largest_group: all.list[0]?.bees.length ?? 0,
      ...(closest && { closest }),
    },
    positions: { x: elements.metres(points.x), y: elements.metres(points.y), z: elements.metres(points.z) },
    at_risk: elements.numbers('u8', bits),
    nearest: { code: elements.numbers('u16', codes), least_m: least, ratio },
    pairs: {
      first: elements.numbers('u32', listed.map((pair) => pair.first), { code: 'delta' }),
      second: elements.numbers('u32', listed.map((pair) => pair.second), { code: 'delta' }),
      distance_m: elements.numbers('f64', listed.map((pair) => pair.distance_m)),
    },
  };
}
