// Coasts and borders on the floor of the swarm.
import { BufferAttribute, BufferGeometry, Group, LineSegments } from 'three';
import type { RawShaderMaterial } from 'three';
import type { Ground } from '../data/ground';
import type { Frame } from './frame';
import { shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

export class GroundLines {
  readonly group = new Group();
  readonly #coasts: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #borders: LineSegments<BufferGeometry, RawShaderMaterial>;

  constructor(readonly frame: Frame) {
    [this.#coasts, this.#borders] = [1, 0.5].map((opacity) => {
      const lines = new LineSegments(new BufferGeometry(), shapeMaterial(false, false));
      lines.frustumCulled = false;
      lines.renderOrder = -1;
      lines.visible = false;
      lines.material.uniforms.opacity.value = opacity;
      this.group.add(lines);
      return lines;
    });
  }

  colour(palette: Palette): void {
    for (const lines of [this.#coasts, this.#borders]) lines.material.uniforms.colour.value = vectorOf(palette.coast);
  }

  show({ coasts, borders }: Ground): void {
    const { centre, box } = this.frame;
    for (const [lines, places] of [[this.#coasts, coasts], [this.#borders, borders]] as const) {
      const numbers = new Float32Array((places.length / 2) * 3);
      for (let i = 0; 2 * i < places.length; ++i) {
        numbers.set([places[2 * i] - centre[0], places[2 * i + 1] - centre[1], box.least[2] - centre[2]], 3 * i);
      }
      lines.geometry.setAttribute('position', new BufferAttribute(numbers, 3));
      lines.visible = numbers.length > 0;
    }
  }
}
