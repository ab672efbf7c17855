// Which bees are in sight. From near by most of a large crowd is not, and need not be drawn.
import type { Matrix4 } from 'three';
import type { Frame } from './frame';
import { lensOf } from './picking';
import type { Placement } from './placement';

/** What is so little beyond the edge of the view still reaches into it. */
const kMargin = 1.06;
/** On which sides of the view a bee is beyond its edge. */
const kLeft = 1;
const kRight = 2;
const kBelow = 4;
const kAbove = 8;
const kBehind = 16;

export class InSight {
  /** Of each bee that was looked at, the sides on which it is out of sight; 0: in sight. */
  readonly #sides: Uint8Array;

  constructor(count: number) {
    this.#sides = new Uint8Array(count);
  }

  /** Looks at all that are shown. */
  look(placement: Placement, frame: Frame, toScreen: Matrix4): void {
    const sides = this.#sides;
    const { x, y, z, shown } = placement;
    const [ax, ay, az, a, bx, by, bz, b, wx, wy, wz, w] = lensOf(placement, frame, toScreen).rows;
    const count = shown ? shown.length : x.length;
    for (let i = 0; i < count; ++i) {
      const bee = shown ? shown[i] : i;
      const px = x[bee];
      const py = y[bee];
      const pz = z[bee];
      const depth = wx * px + wy * py + wz * pz + w;
      if (depth <= 0) {
        sides[bee] = kBehind;
        continue;
      }
      const edge = kMargin * depth;
      const across = ax * px + ay * py + az * pz + a;
      const up = bx * px + by * py + bz * pz + b;
      sides[bee] =
        (across < -edge ? kLeft : across > edge ? kRight : 0) | (up < -edge ? kBelow : up > edge ? kAbove : 0);
    }
  }

  /** Of these bees, or of all, those in sight. */
  of(bees: Uint32Array | null): Uint32Array {
    const sides = this.#sides;
    const seen = new Uint32Array(bees ? bees.length : sides.length);
    let count = 0;
    for (let i = 0; i < seen.length; ++i) {
      const bee = bees ? bees[i] : i;
      if (sides[bee] === 0) seen[count++] = bee;
    }
    return seen.subarray(0, count);
  }

  /** Of lines between bees, two by two, those that may cross the view: not those beyond one of its edges. */
  ofLines(ends: Uint32Array): Uint32Array {
    const sides = this.#sides;
    const seen = new Uint32Array(ends.length);
    let count = 0;
    for (let i = 0; i < ends.length; i += 2) {
      if ((sides[ends[i]] & sides[ends[i + 1]]) !== 0) continue;
      seen[count++] = ends[i];
      seen[count++] = ends[i + 1];
    }
    return seen.subarray(0, count);
  }
}
