// The measure tool: a line between two bees or places, and how far apart they are.
import { BufferAttribute, BufferGeometry, Group, LineSegments, Points } from 'three';
import type { RawShaderMaterial } from 'three';
import type { Triple } from '../data/positions';
import type { Frame } from './frame';
import { ringMaterial, shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

export class Ruler {
  readonly group = new Group();
  readonly #line: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #ends: Points<BufferGeometry, RawShaderMaterial>;

  constructor(readonly frame: Frame) {
    this.#line = new LineSegments(new BufferGeometry(), shapeMaterial(false, true));
    this.#ends = new Points(new BufferGeometry(), ringMaterial(14));
    for (const part of [this.#line, this.#ends]) {
      part.frustumCulled = false;
      part.renderOrder = 11;
      this.group.add(part);
    }
    this.group.visible = false;
  }

  colour(palette: Palette): void {
    for (const part of [this.#line, this.#ends]) part.material.uniforms.colour.value = vectorOf(palette.out);
  }

  setPixelRatio(ratio: number): void {
    this.#ends.material.uniforms.ratio.value = ratio;
  }

  /** None, one end, or two: in metres of the axes. A third line stands upright where the two differ in height. */
  show(ends: Triple[]): void {
    this.group.visible = ends.length > 0;
    const scene = ends.map((end) => end.map((metres, axis) => metres - this.frame.centre[axis]) as Triple);
    const numbers = Float32Array.from(scene.flat());
    const lines = scene.length === 2 ? [...scene, scene[0], [scene[1][0], scene[1][1], scene[0][2]], [scene[1][0], scene[1][1], scene[0][2]], scene[1]] : [];
    for (const [part, places] of [[this.#ends, numbers], [this.#line, Float32Array.from(lines.flat())]] as const) {
      part.geometry.dispose();
      part.geometry.setAttribute('position', new BufferAttribute(places, 3));
    }
  }
}
