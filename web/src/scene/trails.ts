// Where bees came from in the last seconds: lines that fade.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, LineSegments } from 'three';
import type { RawShaderMaterial } from 'three';
import type { Fixes } from '../data/fixes';
import type { Frame } from './frame';
import { shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

const kMostVertices = 240000;
const kPiecesEach = 24;

export class Trails {
  readonly #positions = new Float32Array(3 * kMostVertices);
  readonly #strengths = new Float32Array(kMostVertices);
  readonly lines: LineSegments<BufferGeometry, RawShaderMaterial>;
  #used = 0;

  constructor(readonly frame: Frame) {
    const geometry = new BufferGeometry();
    const positions = new BufferAttribute(this.#positions, 3);
    const strengths = new BufferAttribute(this.#strengths, 1);
    geometry.setAttribute('position', positions.setUsage(DynamicDrawUsage));
    geometry.setAttribute('strength', strengths.setUsage(DynamicDrawUsage));
    this.lines = new LineSegments(geometry, shapeMaterial(true, false));
    this.lines.frustumCulled = false;
    this.lines.material.uniforms.opacity.value = 0.7;
  }

  colour(palette: Palette): void {
    this.lines.material.uniforms.colour.value = vectorOf(palette.plain);
  }

  hide(): void {
    this.lines.visible = false;
  }

  /** Trails of as many of these bees as there is room for. */
  draw(fixes: Fixes, bees: Uint32Array, time_s: number, length_s: number): void {
    this.#used = 0;
    for (let i = 0; i < bees.length && this.#used + 2 * kPiecesEach <= kMostVertices; ++i) {
      this.#drawOne(fixes, bees[i], time_s, length_s);
    }
    const { geometry } = this.lines;
    for (const [name, width] of [['position', 3], ['strength', 1]] as const) {
      const attribute = geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.#used * width);
      attribute.needsUpdate = true;
    }
    geometry.setDrawRange(0, this.#used);
    this.lines.visible = true;
  }

  #drawOne(fixes: Fixes, bee: number, time_s: number, length_s: number): void {
    const { start, step } = fixes.positions;
    const scratch = [new Float32Array(1), new Float32Array(1), new Float32Array(1)] as const;
    const put = (strength: number): void => {
      for (let axis = 0; axis < 3; ++axis) {
        this.#positions[3 * this.#used + axis] =
          start[axis] + step[axis] * scratch[axis][0] - this.frame.centre[axis];
      }
      this.#strengths[this.#used++] = strength;
    };
    // In equal steps of time: as many pieces for a bee with few fixes as with many.
    let before: [number, number, number] | null = null;
    let fixBefore = -1;
    for (let piece = 0; piece <= kPiecesEach; ++piece) {
      const share = piece / kPiecesEach;
      const there = fixes.place(bee, time_s - length_s * (1 - share), ...scratch, 0);
      const fix = fixes.fixAt(bee, time_s - length_s * (1 - share));
      if (there && before && !fixes.isGapWithin(fixBefore, fix)) {
        const now = scratch.map((one) => one[0]);
        scratch.forEach((one, axis) => (one[0] = (before as number[])[axis]));
        put(share - 1 / kPiecesEach);
        scratch.forEach((one, axis) => (one[0] = now[axis]));
        put(share);
      }
      before = there ? [scratch[0][0], scratch[1][0], scratch[2][0]] : null;
      fixBefore = fix;
    }
  }
}
