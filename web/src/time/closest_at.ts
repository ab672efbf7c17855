// Which two are closest at a moment, in words: of a conflict that is at its closest then, of the engine's sample of that moment, or
// of the positions that are shown; where none of these says it, of the sample before it, with its time.
import { closestNow } from '../data/closest_now';
import { sampleAt, type Recording } from '../data/recording';
import { formatHorizontal, formatVertical } from '../text/apart';
import { formatMoment } from '../text/calendar';
import { isolate } from '../text/names';
import { formatBelow } from '../text/numbers';
import { isOpenAt } from './unknown';

/** Moments nearer to each other than this are one. */
const kMoment_s = 1e-6;

export interface ClosestWords {
  apart: string;
  /** Empty, or " at" the time of the sample before it. */
  when: string;
  pair: string;
}

/** The conflict that is at its closest in the moment shown, so that the moment says what its row says. */
function conflictAt({ conflicts }: Recording, within_s: number): number {
  return conflicts.closest_s.findIndex((time_s) => Math.abs(time_s - within_s) < kMoment_s);
}

interface Separated {
  first: number;
  second: number;
  distance_m: number;
  horizontal_m?: number | undefined;
  height_m?: number | undefined;
}

function words({ head, names }: Recording, of: Separated, when: string): ClosestWords {
  const pair = [of.first, of.second].map((bee) => isolate(names.of(bee))).join(' and ');
  const { horizontal_m, height_m } = of;
  if (head.vertical_m === undefined || horizontal_m === undefined || height_m === undefined) {
    return { apart: formatBelow(of.distance_m, head.threshold_m, 3), when, pair };
  }
  return { apart: `${formatHorizontal(horizontal_m, head)} horizontally, ${formatVertical(height_m, head)} in height`, when, pair };
}

/** 'open': not known, as one may be closer in its gap. Null: nothing is known of any two. */
export function closestAt(swarm: Recording, within_s: number): ClosestWords | 'open' | null {
  const { separation, conflicts, fixes, head } = swarm;
  const exact = conflictAt(swarm, within_s);
  const sample = sampleAt(separation.time_s, within_s);
  // Others may be closer to each other in that moment.
  const closest = exact >= 0 && (separation.apart !== null || sample < 0 || conflicts.distance_m[exact] <= separation.distance_m[sample]);
  if (!closest && isOpenAt(separation, within_s)) return 'open';
  const [of, place] = closest ? [conflicts, exact] : [separation, sample];
  const since_s = closest || sample < 0 ? 0 : within_s - separation.time_s[sample];
  if (!closest && (sample < 0 || Math.abs(since_s) > kMoment_s)) {
    const now = closestNow(fixes, head, within_s);
    if (now) return words(swarm, now, '');
  }
  // Nothing of bees that have gone since, or come later.
  if (place < 0 || since_s < -kMoment_s || ![of.first[place], of.second[place]].every((bee) => fixes.isThere(bee, within_s))) return null;
  const when = since_s > kMoment_s ? ` at ${formatMoment(within_s - since_s, head.time)}` : '';
  return words(
    swarm,
    {
      first: of.first[place],
      second: of.second[place],
      distance_m: of.distance_m[place],
      horizontal_m: of.apart?.horizontal_m[place],
      height_m: of.apart?.height_m[place],
    },
    when,
  );
}
