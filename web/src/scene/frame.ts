// The scene's own coordinates: metres from the middle of what is shown, so that the small numbers
// of a graphics card stay exact where the bees are.
import type { Box, Triple } from '../data/positions';

export interface Frame {
  box: Box;
  centre: Triple;
  /** Half the diagonal; never nothing. */
  radius: number;
}

export function frameAround(box: Box, threshold_m: number): Frame {
  const centre = [0, 1, 2].map((axis) => (box.least[axis] + box.most[axis]) / 2) as Triple;
  const half = Math.hypot(...[0, 1, 2].map((axis) => box.most[axis] - box.least[axis])) / 2;
  return { box, centre, radius: half > 0 ? half : Math.max(threshold_m, 1) };
}
