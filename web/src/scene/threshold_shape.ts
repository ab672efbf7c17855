// What is too close to the selected bee: a sphere, or with a limit in height a cylinder.
import { BufferAttribute, BufferGeometry, CylinderGeometry, Group, LineSegments, Mesh, SphereGeometry, Vector3 } from 'three';
import type { RawShaderMaterial } from 'three';
import { shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

const kAround = 96;

function circle(radius: number, plane: (c: number, s: number) => [number, number, number]): number[] {
  const places: number[] = [];
  for (let i = 0; i < kAround; ++i) {
    for (const step of [i, i + 1]) {
      const angle = (2 * Math.PI * step) / kAround;
      places.push(...plane(radius * Math.cos(angle), radius * Math.sin(angle)));
    }
  }
  return places;
}

function outline(radius: number, vertical: number | null): number[] {
  if (vertical === null) {
    return [
      ...circle(radius, (c, s) => [c, s, 0]),
      ...circle(radius, (c, s) => [c, 0, s]),
      ...circle(radius, (c, s) => [0, c, s]),
    ];
  }
  const posts = [0, 1, 2, 3].flatMap((quarter) => {
    const [c, s] = [Math.cos((quarter * Math.PI) / 2), Math.sin((quarter * Math.PI) / 2)];
    return [radius * c, radius * s, -vertical, radius * c, radius * s, vertical];
  });
  return [-vertical, 0, vertical].flatMap((z) => circle(radius, (c, s) => [c, s, z])).concat(posts);
}

export class ThresholdShape {
  readonly group = new Group();
  #parts: { lines: LineSegments<BufferGeometry, RawShaderMaterial>; body: Mesh<BufferGeometry, RawShaderMaterial> } | null = null;
  #colour = '#ffffff';

  constructor(
    readonly threshold_m: number,
    readonly vertical_m: number | null,
  ) {
    this.group.visible = false;
  }

  colour(palette: Palette): void {
    this.#colour = palette.focus;
    if (!this.#parts) return;
    for (const part of [this.#parts.lines, this.#parts.body]) part.material.uniforms.colour.value = vectorOf(palette.focus);
  }

  lift(times: number): void {
    this.group.scale.z = times;
  }

  place(at: Vector3 | null): void {
    this.group.visible = at !== null;
    if (!at) return;
    this.group.position.copy(at);
    this.#parts ??= this.#make();
  }

  /** Once there is a bee to put it around: what is seen first does without. */
  #make(): { lines: LineSegments<BufferGeometry, RawShaderMaterial>; body: Mesh<BufferGeometry, RawShaderMaterial> } {
    const { threshold_m, vertical_m } = this;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(outline(threshold_m, vertical_m)), 3));
    const lines = new LineSegments(geometry, shapeMaterial(false, true));
    const solid =
      vertical_m === null
        ? new SphereGeometry(threshold_m, 48, 32)
        : new CylinderGeometry(threshold_m, threshold_m, 2 * vertical_m, 64).rotateX(Math.PI / 2);
    const body = new Mesh(solid, shapeMaterial(false, true));
    lines.material.uniforms.opacity.value = 0.55;
    body.material.uniforms.opacity.value = 0.045;
    lines.renderOrder = 4;
    body.renderOrder = 3;
    for (const part of [lines, body]) part.material.uniforms.colour.value = vectorOf(this.#colour);
    this.group.add(body, lines);
    return { lines, body };
  }
}
