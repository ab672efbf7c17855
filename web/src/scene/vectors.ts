// Where moving bees would be after a while if they flew on as they do: a line from each.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, LineSegments } from 'three';
import type { RawShaderMaterial } from 'three';
import type { Fixes } from '../data/fixes';
import { speedsOf } from '../data/speeds';
import type { Triple } from '../data/positions';
import { niceBelow } from '../text/nice_steps';
import type { Frame } from './frame';
import { shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';
import { placeIn, type Placement } from './placement';

const kMostBees = 20000;
/** So long a line of a usual bee is, as a share of all that is seen. */
const kLength = 0.07;

/** How far ahead lines lead: a time that people count in. */
export function aheadOf(fixes: Fixes, radius_m: number): number {
  const { usual_mps } = speedsOf(fixes);
  return usual_mps > 0 ? niceBelow((2 * kLength * radius_m) / usual_mps) : 1;
}

export class Vectors {
  readonly lines: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #positions = new Float32Array(6 * kMostBees);

  constructor(readonly frame: Frame) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.#positions, 3).setUsage(DynamicDrawUsage));
    this.lines = new LineSegments(geometry, shapeMaterial(false, false));
    this.lines.frustumCulled = false;
    this.lines.visible = false;
    this.lines.material.uniforms.opacity.value = 0.5;
  }

  colour(palette: Palette): void {
    this.lines.material.uniforms.colour.value = vectorOf(palette.focus);
  }

  hide(): void {
    this.lines.visible = false;
  }

  /** Of very many bees, of those at risk and as many of the others as there is room for, evenly chosen. */
  draw(fixes: Fixes, placement: Placement, time_s: number, ahead_s: number): void {
    const { shown, atRisk } = placement;
    const bees = shown ?? Uint32Array.from({ length: fixes.bees }, (_, bee) => bee);
    const stride = Math.max(1, Math.ceil(bees.length / (kMostBees / 2)));
    let used = 0;
    const velocity: Triple = [0, 0, 0];
    const put = (bee: number): void => {
      if (used + 2 > 2 * kMostBees || !fixes.velocity(bee, time_s, velocity)) return;
      const place = placeIn(placement, bee);
      for (let axis = 0; axis < 3; ++axis) {
        const from = place[axis] - this.frame.centre[axis];
        this.#positions[3 * used + axis] = from;
        this.#positions[3 * used + 3 + axis] = from + ahead_s * velocity[axis];
      }
      used += 2;
    };
    if (bees.length <= kMostBees) for (const bee of bees) put(bee);
    else {
      for (const bee of atRisk.subarray(0, kMostBees / 2)) put(bee);
      for (let i = 0; i < bees.length; i += stride) put(bees[i]);
    }
    const attribute = this.lines.geometry.getAttribute('position') as BufferAttribute;
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, 3 * used);
    attribute.needsUpdate = true;
    this.lines.geometry.setDrawRange(0, used);
    this.lines.visible = true;
  }
}
