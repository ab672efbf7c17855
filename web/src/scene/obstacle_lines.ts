// What stands in the way, as the edges of it.
import { BufferAttribute, BufferGeometry, Group, LineSegments, Vector3 } from 'three';
import type { RawShaderMaterial } from 'three';
import { linesOf, obstacleName } from '../data/obstacles';
import type { Obstacle } from '../data/page';
import type { Triple } from '../data/positions';
import type { Frame } from './frame';
import { shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

interface Seen {
  name: string;
  places: Triple[];
}

export class ObstacleLines {
  readonly group = new Group();
  readonly #lines: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #seen: Seen[];

  constructor(
    readonly frame: Frame,
    obstacles: Obstacle[],
  ) {
    this.#seen = obstacles.map((obstacle, place) => ({ name: obstacleName(obstacle, place), places: linesOf(obstacle, frame.box) }));
    const geometry = new BufferGeometry();
    const numbers = this.#seen.flatMap(({ places }) => places.flatMap((place) => place.map((metres, axis) => metres - frame.centre[axis])));
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(numbers), 3));
    this.#lines = new LineSegments(geometry, shapeMaterial(false, false));
    this.#lines.frustumCulled = false;
    this.#lines.visible = numbers.length > 0;
    this.group.add(this.#lines);
  }

  colour(palette: Palette): void {
    this.#lines.material.uniforms.colour.value = vectorOf(palette.obstacle);
  }

  /** The name of the smallest that is seen around there; null where none is. */
  nameAt(x: number, y: number, project: (place: Vector3) => { x: number; y: number } | null): string | null {
    let found: string | null = null;
    let least = Infinity;
    for (const { name, places } of this.#seen) {
      const corners = places.map((place) => project(new Vector3(...this.frame.toScene(place)))).filter((corner) => corner !== null);
      const [xs, ys] = [corners.map((corner) => corner.x), corners.map((corner) => corner.y)];
      const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
      const area = (right - left) * (bottom - top);
      if (x < left - 3 || x > right + 3 || y < top - 3 || y > bottom + 3 || area >= least) continue;
      if (!isWithin(x, y, corners)) continue;
      [found, least] = [name, area];
    }
    return found;
  }
}

/** Whether the place is within the hull of the corners, or three pixels beside it. */
function isWithin(x: number, y: number, corners: { x: number; y: number }[]): boolean {
  // Outside, there is a direction in which all corners lie on the other side.
  for (let step = 0; step < 64; ++step) {
    const angle = (2 * Math.PI * step) / 64;
    const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
    const farthest = Math.max(...corners.map((corner) => (corner.x - x) * dx + (corner.y - y) * dy));
    if (farthest < -3) return false;
  }
  return true;
}
