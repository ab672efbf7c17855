// Which two are closest at a moment, of the positions that the page shows: between the moments for which the engine has said it.
import { cartesianOf, geographicOf } from './earth';
import type { Fixes } from './fixes';
import type { RecordingHead } from './page';
import type { Triple } from './positions';

export interface ClosestNow {
  first: number;
  second: number;
  distance_m: number;
  horizontal_m: number;
  height_m: number;
}

/** Of more, all pairs would be too many for every moment that is shown. */
const kMostBees = 300;

interface There {
  bee: number;
  at: Triple;
  /** On the Earth the place below it at height 0, otherwise the same. */
  below: Triple;
  height_m: number;
}

function apart(one: Triple, other: Triple): number {
  return Math.hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

/**
 * Whether the bee is where it stays from its first fix to the second, or up to its last one from the one before. A drone of a show
 * stands on the ground so, and is close to none that stands.
 */
function mayStand(fixes: Fixes, bee: number, time_s: number): boolean {
  const { x, y, z } = fixes.positions;
  const from = fixes.firstOf(bee);
  const last = from + fixes.countOf(bee) - 1;
  const same = (a: number, b: number): boolean => x[a] === x[b] && y[a] === y[b] && z[a] === z[b];
  if (last === from) return true;
  return (time_s <= fixes.timeOf(from + 1) && same(from, from + 1)) || (time_s >= fixes.timeOf(last - 1) && same(last - 1, last));
}

function thereAt(fixes: Fixes, head: RecordingHead, time_s: number): There[] | null {
  const [x, y, z] = [new Float32Array(1), new Float32Array(1), new Float32Array(1)];
  const { start, step } = fixes.positions;
  const there: There[] = [];
  for (let bee = 0; bee < fixes.bees; ++bee) {
    if (!fixes.place(bee, time_s, x, y, z, 0)) continue;
    if (mayStand(fixes, bee, time_s)) return null;
    const place: Triple = [start[0] + step[0] * x[0], start[1] + step[1] * y[0], start[2] + step[2] * z[0]];
    if (!head.origin) {
      there.push({ bee, at: place, below: [place[0], place[1], 0], height_m: place[2] });
      continue;
    }
    const geographic = geographicOf(head.origin, place);
    there.push({ bee, at: cartesianOf(geographic), below: cartesianOf({ ...geographic, height_m: 0 }), height_m: place[2] });
  }
  return there;
}

/**
 * The two that are closest; with a vertical threshold those nearest to a conflict. Null where there are no two, too many, where
 * some may stand on the ground, or where positions are shown less exactly than that would be told.
 */
export function closestNow(fixes: Fixes, head: RecordingHead, time_s: number): ClosestNow | null {
  if (fixes.bees > kMostBees) return null;
  const there = thereAt(fixes, head, time_s);
  if (!there) return null;
  let found: ClosestNow | null = null;
  let least = Infinity;
  for (let i = 0; i < there.length; ++i) {
    for (let k = i + 1; k < there.length; ++k) {
      const [one, other] = [there[i], there[k]];
      const distance_m = apart(one.at, other.at);
      const horizontal_m = apart(one.below, other.below);
      const height_m = Math.abs(one.height_m - other.height_m);
      const measure =
        head.vertical_m === undefined ? distance_m : Math.max(horizontal_m / head.threshold_m, height_m / head.vertical_m);
      if (!(measure < least)) continue;
      least = measure;
      found = { first: one.bee, second: other.bee, distance_m, horizontal_m, height_m };
    }
  }
  return found && isExact(found, head) ? found : null;
}

/** To a two-hundredth of what is told, in height too where that is told. */
function isExact({ distance_m, horizontal_m, height_m }: ClosestNow, head: RecordingHead): boolean {
  const told = head.vertical_m === undefined ? [distance_m] : [Math.max(horizontal_m, head.threshold_m), Math.max(height_m, head.vertical_m)];
  return told.every((metres) => 2 * head.position_error_m <= metres / 200);
}
