// The selected bee as its planner has it: a ghost at its nominal place, the tube around it, and the claim, which is
// the tube along all branches on which the bee may be, to their stops.
import { BufferAttribute, BufferGeometry, CylinderGeometry, Group, LineSegments, Mesh, Points, SphereGeometry, Vector3 } from 'three';
import type { RawShaderMaterial } from 'three';
import type { Claim } from '../data/fleet';
import type { Triple } from '../data/positions';
import type { Frame } from './frame';
import { ringMaterial, shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

export interface Guided {
  ghost: Triple;
  tube_m: number;
  claim: Claim | null;
}

const kUp = new Vector3(0, 1, 0);

/** Translucent bodies that show as one where they lie in each other: depth first, then colour where it is the nearest. */
class Bodies {
  readonly group = new Group();
  readonly #depth = shapeMaterial(false, false);
  readonly #colour = shapeMaterial(false, false);
  readonly #balls: Mesh[] = [];
  readonly #rods: Mesh[] = [];
  readonly #ball = new SphereGeometry(1, 32, 20);
  readonly #rod = new CylinderGeometry(1, 1, 1, 32, 1, true);

  constructor(
    readonly order: number,
    opacity: number,
  ) {
    this.#depth.colorWrite = false;
    this.#depth.depthWrite = true;
    this.#colour.uniforms.opacity.value = opacity;
  }

  colour(colour: string): void {
    this.#colour.uniforms.colour.value = vectorOf(colour);
  }

  /** Balls at the places and rods along the lines, of this radius. */
  show(places: Vector3[], lines: [Vector3, Vector3][], radius: number): void {
    this.#fill(this.#balls, this.#ball, places.length);
    this.#fill(this.#rods, this.#rod, lines.length);
    places.forEach((place, i) => {
      for (const mesh of [this.#balls[2 * i], this.#balls[2 * i + 1]]) {
        mesh.position.copy(place);
        mesh.scale.setScalar(radius);
      }
    });
    lines.forEach(([from, to], i) => {
      const along = to.clone().sub(from);
      const length = along.length();
      for (const mesh of [this.#rods[2 * i], this.#rods[2 * i + 1]]) {
        mesh.visible &&= length > 0;
        mesh.position.copy(from).addScaledVector(along, 0.5);
        mesh.quaternion.setFromUnitVectors(kUp, length > 0 ? along.clone().divideScalar(length) : kUp);
        mesh.scale.set(radius, length, radius);
      }
    });
  }

  /** Two meshes for each: its depth and its colour. */
  #fill(meshes: Mesh[], geometry: BufferGeometry, count: number): void {
    while (meshes.length < 2 * count) {
      for (const [material, later] of [[this.#depth, 0], [this.#colour, 0.5]] as const) {
        const mesh = new Mesh(geometry, material);
        mesh.renderOrder = this.order + later;
        meshes.push(mesh);
        this.group.add(mesh);
      }
    }
    meshes.forEach((mesh, i) => (mesh.visible = i < 2 * count));
  }
}

export class Guidance {
  readonly group = new Group();
  readonly #tube = new Bodies(5, 0.3);
  readonly #claim = new Bodies(7, 0.2);
  readonly #lines = new LineSegments(new BufferGeometry(), shapeMaterial(false, true));
  readonly #ghost: Points<BufferGeometry, RawShaderMaterial>;
  readonly #stops: Points<BufferGeometry, RawShaderMaterial>;

  constructor(readonly frame: Frame) {
    this.#ghost = new Points(new BufferGeometry(), ringMaterial(12));
    this.#stops = new Points(new BufferGeometry(), ringMaterial(7));
    for (const part of [this.#lines, this.#ghost, this.#stops]) {
      part.frustumCulled = false;
      part.renderOrder = 9;
    }
    this.group.add(this.#claim.group, this.#tube.group, this.#lines, this.#ghost, this.#stops);
    this.group.visible = false;
  }

  colour(palette: Palette): void {
    for (const bodies of [this.#tube, this.#claim]) bodies.colour(palette.ghost);
    for (const part of [this.#lines, this.#ghost, this.#stops]) {
      part.material.uniforms.colour.value = vectorOf(palette.ghost);
    }
  }

  setPixelRatio(ratio: number): void {
    for (const part of [this.#ghost, this.#stops]) part.material.uniforms.ratio.value = ratio;
  }

  show(guided: Guided | null): void {
    this.group.visible = guided !== null;
    if (!guided) return;
    const place = (at: Triple): Vector3 => new Vector3(...at).sub(new Vector3(...this.frame.centre));
    const ghost = place(guided.ghost);
    const path = (guided.claim?.path ?? []).map(place);
    const sides = (guided.claim?.sides ?? []).map(({ from, stop }): [Vector3, Vector3] => [place(from), place(stop)]);
    const along = path.slice(1).map((to, i): [Vector3, Vector3] => [path[i], to]);
    const lines = [...along, ...sides];
    this.#tube.show([ghost], [], guided.tube_m);
    this.#claim.show([...path, ...sides.flat()], lines, guided.tube_m);
    const stops = [...path.slice(-1), ...sides.map(([, stop]) => stop)];
    for (const [part, places] of [[this.#lines, lines.flat()], [this.#ghost, [ghost]], [this.#stops, stops]] as const) {
      part.geometry.dispose();
      const numbers = Float32Array.from(places.flatMap(({ x, y, z }) => [x, y, z]));
      part.geometry.setAttribute('position', new BufferAttribute(numbers, 3));
    }
  }
}
