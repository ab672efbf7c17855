// How far apart two places are that the page shows: of the shown positions, not of the exact ones.
import { cartesianOf, geographicOf } from './earth';
import type { Origin } from './page';
import type { Triple } from './positions';

export interface Measured {
  straight_m: number;
  horizontal_m: number;
  height_m: number;
}

/** On the Earth, horizontally: in a straight line between the places below them at height 0, as everywhere on the page. */
export function measured(one: Triple, other: Triple, origin: Origin | undefined): Measured {
  const height_m = Math.abs(one[2] - other[2]);
  if (!origin) return { straight_m: between(one, other), horizontal_m: Math.hypot(one[0] - other[0], one[1] - other[1]), height_m };
  const places = [one, other].map((place) => geographicOf(origin, place));
  const [high, ground] = [places, places.map((place) => ({ ...place, height_m: 0 }))].map((both) => both.map(cartesianOf));
  return { straight_m: between(high[0], high[1]), horizontal_m: between(ground[0], ground[1]), height_m };
}

function between(one: Triple, other: Triple): number {
  return Math.hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}
