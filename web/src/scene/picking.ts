// Which bee is under the cursor: all of them are projected here, which takes some milliseconds a
// million. One at risk near the cursor goes before all others.
import type { Matrix4 } from 'three';
import type { Frame } from './frame';
import type { Placement } from './placement';

export interface Cursor {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Lens {
  /** Rows of the matrix that takes raw numbers to the screen: x, y and w, each with its constant. */
  rows: Float64Array;
}

export function lensOf(placement: Placement, frame: Frame, toScreen: Matrix4): Lens {
  const m = toScreen.elements;
  const rows = new Float64Array(12);
  [0, 1, 3].forEach((row, place) => {
    let constant = m[12 + row];
    for (let axis = 0; axis < 3; ++axis) {
      rows[4 * place + axis] = m[4 * axis + row] * placement.step[axis];
      constant += m[4 * axis + row] * (placement.start[axis] - frame.centre[axis]);
    }
    rows[4 * place + 3] = constant;
  });
  return { rows };
}

function closestTo(
  cursor: Cursor,
  reach: number,
  placement: Placement,
  lens: Lens,
  bees: Uint32Array | null,
): number | null {
  const { x, y, z } = placement;
  const [ax, ay, az, a, bx, by, bz, b, wx, wy, wz, w] = lens.rows;
  const wantedX = (2 * cursor.x) / cursor.width - 1;
  const wantedY = 1 - (2 * cursor.y) / cursor.height;
  const halfWidth = cursor.width / 2;
  const halfHeight = cursor.height / 2;
  let best: number | null = null;
  // A pixel farther from the cursor weighs as much as a tenth of the depth.
  let bestCost = Infinity;
  const count = bees ? bees.length : x.length;
  for (let i = 0; i < count; ++i) {
    const bee = bees ? bees[i] : i;
    const depth = wx * x[bee] + wy * y[bee] + wz * z[bee] + w;
    if (depth <= 0) continue;
    const dx = ((ax * x[bee] + ay * y[bee] + az * z[bee] + a) / depth - wantedX) * halfWidth;
    if (dx > reach || dx < -reach) continue;
    const dy = ((bx * x[bee] + by * y[bee] + bz * z[bee] + b) / depth - wantedY) * halfHeight;
    const away = Math.hypot(dx, dy);
    if (away > reach) continue;
    const cost = away + 10 * Math.log(depth);
    if (cost < bestCost) {
      bestCost = cost;
      best = bee;
    }
  }
  return best;
}

export function pickBee(cursor: Cursor, placement: Placement, frame: Frame, toScreen: Matrix4): number | null {
  const lens = lensOf(placement, frame, toScreen);
  return (
    closestTo(cursor, 10, placement, lens, placement.atRisk) ??
    closestTo(cursor, 7, placement, lens, placement.shown)
  );
}
