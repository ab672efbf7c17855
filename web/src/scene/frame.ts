// The scene's own coordinates: metres from the middle of what is shown, so that the small numbers
// of a graphics card stay exact where the bees are. Heights may be drawn larger than they are.
import type { Box, Triple } from '../data/positions';
import { niceBelow } from '../text/nice_steps';

/** So many times larger heights can be drawn. */
export const kLifts = [1, 2, 5, 10, 20, 50, 100, 200];
/** What is flatter than this is lifted to about it. */
const kFlat = 0.08;

export class Frame {
  readonly centre: Triple;
  /** How many times larger than they are heights are drawn. */
  lift = 1;
  /** Where there are no heights: all is seen from above. */
  flat = false;
  /** -1 where y counts downwards, as in a picture: so it is drawn. */
  up: 1 | -1 = 1;

  constructor(
    readonly box: Box,
    /** Half the diagonal where there is none. */
    readonly least: number,
  ) {
    this.centre = [0, 1, 2].map((axis) => (box.least[axis] + box.most[axis]) / 2) as Triple;
  }

  /** Half the diagonal; never nothing. */
  get radius(): number {
    const { least, most } = this.box;
    const half = Math.hypot(most[0] - least[0], most[1] - least[1], this.lift * (most[2] - least[2])) / 2;
    return half > 0 ? half : this.least;
  }

  fromScene(place: Triple): Triple {
    const [x, y, z] = this.centre;
    return [place[0] + x, this.up * place[1] + y, place[2] / this.lift + z];
  }

  toScene(place: Triple): Triple {
    const [x, y, z] = this.centre;
    return [place[0] - x, this.up * (place[1] - y), this.lift * (place[2] - z)];
  }
}

export function frameAround(box: Box, threshold_m: number): Frame {
  return new Frame(box, Math.max(threshold_m, 1));
}

/** How much heights over a wide area must be lifted to be seen. */
export function liftFor({ least, most }: Box, threshold_m: number, vertical_m: number | undefined): number {
  const wide = Math.max(most[0] - least[0], most[1] - least[1]);
  const high = most[2] - least[2];
  // What is too close to a bee is not to be a tower; a ball is to stay one.
  if (!(high > 0) || high >= kFlat * wide || (vertical_m === undefined && threshold_m > 0)) return 1;
  const most_lift = threshold_m > 0 ? Math.min(kLifts[kLifts.length - 1], (3 * threshold_m) / (vertical_m ?? threshold_m)) : kLifts[kLifts.length - 1];
  return Math.max(1, niceBelow(Math.min(most_lift, (1.6 * kFlat * wide) / high)));
}
