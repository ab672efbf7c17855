// How near the nearest other bee is while bees move, from the positions as they are shown. Only for
// colour: which are too close is in the data, decided on the exact positions.
import { Nearest } from '../data/nearest';
import type { Triple } from '../data/positions';

/** All are compared with all, so there must not be too many for a frame. */
const kMostBees = 3000;
/** From a hundredth of the threshold to a hundred times it. */
const kSpan = 100;

export class Crowding {
  readonly nearest: Nearest;
  readonly #squares: Float32Array;

  private constructor(count: number, threshold_m: number) {
    const ratio = (kSpan * kSpan) ** (1 / 65534);
    this.nearest = new Nearest(new Uint16Array(count), threshold_m / kSpan, ratio);
    this.#squares = new Float32Array(count);
  }

  static for(count: number, threshold_m: number): Crowding | null {
    return count <= kMostBees && threshold_m > 0 ? new Crowding(count, threshold_m) : null;
  }

  /** Codes between which colours change. */
  static range(nearest: Nearest): [number, number] {
    const threshold_m = nearest.least_m * kSpan;
    return [nearest.toCode(threshold_m / 2), nearest.toCode(8 * threshold_m)];
  }

  /** Finds how near the nearest is to each of these bees. */
  measure(bees: Uint32Array, x: Float32Array, y: Float32Array, z: Float32Array, step: Triple): void {
    const squares = this.#squares;
    for (const bee of bees) squares[bee] = Infinity;
    for (let i = 0; i < bees.length; ++i) {
      const a = bees[i];
      const [ax, ay, az] = [x[a], y[a], z[a]];
      let least = squares[a];
      for (let j = i + 1; j < bees.length; ++j) {
        const b = bees[j];
        const dx = step[0] * (x[b] - ax);
        const dy = step[1] * (y[b] - ay);
        const dz = step[2] * (z[b] - az);
        const square = dx * dx + dy * dy + dz * dz;
        if (square < least) least = square;
        if (square < squares[b]) squares[b] = square;
      }
      squares[a] = least;
    }
    for (const bee of bees) {
      this.nearest.codes[bee] = Math.min(65535, Math.round(this.nearest.toCode(Math.sqrt(squares[bee]))));
    }
  }
}
