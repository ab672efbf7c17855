// Rings around the bees that keep their contracts no longer.
import { BufferAttribute, BufferGeometry, Points, type Vector3 } from 'three';
import type { RawShaderMaterial } from 'three';
import { ringMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

export class Outcasts {
  readonly rings: Points<BufferGeometry, RawShaderMaterial>;

  constructor() {
    this.rings = new Points(new BufferGeometry(), ringMaterial(32));
    this.rings.frustumCulled = false;
    this.rings.renderOrder = 10;
    this.rings.visible = false;
  }

  colour(palette: Palette): void {
    this.rings.material.uniforms.colour.value = vectorOf(palette.out);
  }

  setPixelRatio(ratio: number): void {
    this.rings.material.uniforms.ratio.value = ratio;
  }

  place(places: Vector3[]): void {
    this.rings.visible = places.length > 0;
    this.rings.geometry.dispose();
    const numbers = Float32Array.from(places.flatMap(({ x, y, z }) => [x, y, z]));
    this.rings.geometry.setAttribute('position', new BufferAttribute(numbers, 3));
  }
}
