// Between places of the swarm and places on the screen: where a bee is seen, what is under the cursor, and from where we look.
import { Vector3, type Matrix4 } from 'three';
import type { Triple } from '../data/positions';
import type { Orbit } from './camera';
import type { Frame } from './frame';
import { pickBee } from './picking';
import type { Placement } from './placement';

export class Sight {
  #width = 1;
  #height = 1;

  constructor(
    readonly orbit: Orbit,
    readonly frame: Frame,
  ) {}

  resize(width: number, height: number): void {
    [this.#width, this.#height] = [width, height];
  }

  /** The camera in metres of the axes: its place, what it looks at, and how wide it sees. */
  get camera(): number[] {
    const { position, target, fov_deg } = this.orbit.pose;
    return [...this.frame.fromScene(position.toArray()), ...this.frame.fromScene(target.toArray()), fov_deg];
  }

  set camera([x, y, z, tx, ty, tz, fov_deg]: number[]) {
    const [position, target] = [[x, y, z], [tx, ty, tz]].map((place) => new Vector3(...this.frame.toScene(place as Triple)));
    if (position.distanceTo(target) > 0 && fov_deg >= 1 && fov_deg <= 90) this.orbit.goTo({ position, target, fov_deg });
  }

  /** Where on the canvas a place of the scene is seen. */
  project(place: Vector3 | null): { x: number; y: number } | null {
    const at = place?.clone().project(this.orbit.camera);
    return at ? { x: ((at.x + 1) * this.#width) / 2, y: ((1 - at.y) * this.#height) / 2 } : null;
  }

  /** From metres from the centre of what is shown to the screen. */
  toScreen(): Matrix4 {
    const { camera } = this.orbit;
    const toScreen = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
    return toScreen.scale(new Vector3(1, this.frame.up, this.frame.lift));
  }

  /** The bee that is seen there. */
  pick(x: number, y: number, placement: Placement): number | null {
    return pickBee({ x, y, width: this.#width, height: this.#height }, placement, this.frame, this.toScreen());
  }

  /** The place on the floor of the swarm that is seen there, in metres of the axes; null where none is. */
  floorUnder(x: number, y: number): Triple | null {
    const { camera } = this.orbit;
    const towards = new Vector3((2 * x) / this.#width - 1, 1 - (2 * y) / this.#height, 0.5).unproject(camera).sub(camera.position);
    const floor = this.frame.toScene(this.frame.box.least)[2];
    const reach = (floor - camera.position.z) / towards.z;
    if (!(reach > 0) || !Number.isFinite(reach)) return null;
    return this.frame.fromScene(camera.position.clone().addScaledVector(towards, reach).toArray());
  }
}
