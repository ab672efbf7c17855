// A small cross of the three axes that turns with the view.
import { Vector3 } from 'three';
import type { Camera } from 'three';
import { drawing } from '../text/element';

const kArm = 26;

export class Compass {
  readonly box = drawing('svg', { class: 'compass', viewBox: '-54 -40 108 80', 'aria-hidden': 'true' });
  readonly #arms: { line: SVGLineElement; text: SVGTextElement }[];

  constructor(
    axes: readonly string[],
    /** -1 where y is drawn downwards. */
    readonly up: number,
  ) {
    this.#arms = axes.map((name) => ({
      line: drawing('line', { x1: 0, y1: 0 }),
      text: drawing('text', {}, name),
    }));
    for (const { line, text } of this.#arms) this.box.append(line, text);
  }

  turn(camera: Camera): void {
    const direction = new Vector3();
    const back = camera.quaternion.clone().invert();
    this.#arms.forEach(({ line, text }, axis) => {
      direction.set(axis === 0 ? 1 : 0, axis === 1 ? this.up : 0, axis === 2 ? 1 : 0).applyQuaternion(back);
      const [x, y] = [direction.x * kArm, -direction.y * kArm];
      line.setAttribute('x2', x.toFixed(1));
      line.setAttribute('y2', y.toFixed(1));
      text.setAttribute('x', (x * 1.38).toFixed(1));
      text.setAttribute('y', (y * 1.38 + 3.5).toFixed(1));
      // An arm that points at us says little, and its name would lie over the others.
      text.style.opacity = Math.hypot(x, y) < 0.3 * kArm ? '0' : '1';
    });
  }
}
