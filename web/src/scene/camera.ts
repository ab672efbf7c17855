// Where we look from: orbit, pan and zoom by mouse, touch and keys, and flights to a place.
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Frame } from './frame';

const kFlight_ms = 450;
/** Pixels beside, above and below the swarm, seen from home, for what is written around it. */
const kMargin = { aside: 66, above: 42 };
/** From the south, a little from the west and from above. */
const kHome = new Vector3(-0.45, -1, 0.62).normalize();

export interface Pose {
  position: Vector3;
  target: Vector3;
}

export class Orbit {
  readonly camera = new PerspectiveCamera(40, 1, 0.1, 1000);
  readonly #controls: OrbitControls;
  readonly #listeners: (() => void)[] = [];
  #flight = 0;
  #home: Pose = { position: new Vector3(0, -1, 0), target: new Vector3() };
  #atHome = true;
  #fill = { x: 1, y: 1 };

  constructor(
    canvas: HTMLCanvasElement,
    readonly frame: Frame,
  ) {
    this.camera.up.set(0, 0, 1);
    this.#controls = new OrbitControls(this.camera, canvas);
    this.#controls.zoomToCursor = true;
    this.#controls.zoomSpeed = 1.4;
    this.#controls.minDistance = frame.radius * 1e-5;
    this.#controls.maxDistance = frame.radius * 20;
    this.#controls.addEventListener('start', () => {
      this.#stop();
      this.#atHome = false;
    });
    this.#controls.addEventListener('change', () => this.#changed());
  }

  get homeDistance(): number {
    return this.#home.position.distanceTo(this.#home.target);
  }

  get distance(): number {
    return this.#controls.getDistance();
  }

  get pose(): Pose {
    return { position: this.camera.position, target: this.#controls.target };
  }

  onChange(listener: () => void): void {
    this.#listeners.push(listener);
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.#fill = {
      x: Math.max(0.55, 1 - (2 * kMargin.aside) / width),
      y: Math.max(0.55, 1 - (2 * kMargin.above) / height),
    };
    this.camera.updateProjectionMatrix();
    this.#home = this.#fit(kHome);
    if (this.#atHome) this.look(this.#home);
  }

  /** Takes the pose at once. */
  look(pose: Pose): void {
    this.camera.position.copy(pose.position);
    this.#controls.target.copy(pose.target);
    this.#controls.update();
    this.#changed();
  }

  /** Takes over the pose of another view that is linked with this one. */
  follow(pose: Pose): void {
    this.#stop();
    this.#atHome = false;
    this.look(pose);
  }

  home(): void {
    this.#fly(this.#home, () => {
      this.#atHome = true;
    });
  }

  lookFromAbove(): void {
    const { target } = this.pose;
    // Not quite from above, so that north stays up.
    const position = target.clone().add(new Vector3(0, -1e-3, 1).multiplyScalar(this.distance));
    this.#fly({ position, target: target.clone() });
  }

  lookFromSide(): void {
    const { target } = this.pose;
    this.#fly({ position: target.clone().add(new Vector3(0, -this.distance, 0)), target: target.clone() });
  }

  /** Goes to where the place is seen from the distance, in the direction that we look in. */
  flyTo(place: Vector3, distance: number): void {
    const back = this.camera.position.clone().sub(this.#controls.target).normalize();
    // In a window that is taller than wide, from farther away.
    const reach = Math.max(distance / Math.min(1, this.camera.aspect), this.#controls.minDistance * 2);
    this.#fly({ position: place.clone().addScaledVector(back, reach), target: place.clone() });
  }

  turn(aside: number, up: number): void {
    const offset = this.camera.position.clone().sub(this.#controls.target);
    const flat = Math.hypot(offset.x, offset.y);
    const azimuth = Math.atan2(offset.y, offset.x) + aside;
    const limit = Math.PI / 2 - 1e-3;
    const height = Math.max(-limit, Math.min(limit, Math.atan2(offset.z, flat) + up));
    const length = offset.length();
    offset
      .set(Math.cos(azimuth) * Math.cos(height), Math.sin(azimuth) * Math.cos(height), Math.sin(height))
      .multiplyScalar(length);
    this.#moveTo(this.#controls.target.clone().add(offset), this.#controls.target);
  }

  /** Shares of what is seen, to the right and up. */
  shift(right: number, up: number): void {
    const reach = 2 * this.distance * Math.tan((this.camera.fov * Math.PI) / 360);
    const move = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * reach);
    move.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * reach);
    this.#moveTo(this.camera.position.clone().add(move), this.#controls.target.clone().add(move));
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.#controls.target).multiplyScalar(1 / factor);
    this.#moveTo(this.#controls.target.clone().add(offset), this.#controls.target);
  }

  #moveTo(position: Vector3, target: Vector3): void {
    this.#stop();
    this.#atHome = false;
    this.look({ position, target });
  }

  /** From where, in this direction, the box fills the view; found in a few steps. */
  #fit(direction: Vector3): Pose {
    const right = new Vector3(0, 0, 1).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360);
    const wide = tall * this.camera.aspect;
    const { box, centre, radius } = this.frame;
    const corners = Array.from({ length: 8 }, (_, bits) => {
      const [x, y, z] = [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? box.most : box.least)[axis] - centre[axis]);
      const at = new Vector3(x, y, z);
      return { right: at.dot(right), up: at.dot(up), towards: at.dot(direction) };
    });
    let [distance, aside, above] = [2.5 * radius, 0, 0];
    for (let step = 0; step < 12; ++step) {
      const seen = corners.map((corner) => {
        const depth = Math.max(1e-3 * radius, distance - corner.towards);
        return { x: (corner.right - aside) / depth / wide, y: (corner.up - above) / depth / tall };
      });
      const [left, end] = [Math.min(...seen.map(({ x }) => x)), Math.max(...seen.map(({ x }) => x))];
      const [low, high] = [Math.min(...seen.map(({ y }) => y)), Math.max(...seen.map(({ y }) => y))];
      aside += ((left + end) / 2) * wide * distance;
      above += ((low + high) / 2) * tall * distance;
      const filled = Math.max((end - left) / this.#fill.x, (high - low) / this.#fill.y) / 2;
      distance = Math.max(0.4 * radius, distance * Math.min(2, Math.max(0.5, 0.3 + 0.7 * filled)));
    }
    const target = new Vector3().addScaledVector(right, aside).addScaledVector(up, above);
    return { position: target.clone().addScaledVector(direction, distance), target };
  }

  #fly(to: Pose, arrived: () => void = () => {}): void {
    this.#stop();
    this.#atHome = false;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.look(to);
      arrived();
      return;
    }
    const from = { position: this.camera.position.clone(), target: this.#controls.target.clone() };
    const begins = performance.now();
    const step = (now: number): void => {
      const share = Math.min(1, Math.max(0, (now - begins) / kFlight_ms));
      const eased = share * share * (3 - 2 * share);
      this.look({
        position: from.position.clone().lerp(to.position, eased),
        target: from.target.clone().lerp(to.target, eased),
      });
      if (share < 1) this.#flight = requestAnimationFrame(step);
      else arrived();
    };
    this.#flight = requestAnimationFrame(step);
  }

  #stop(): void {
    cancelAnimationFrame(this.#flight);
  }

  #changed(): void {
    const far = this.camera.position.length() + 4 * this.frame.radius;
    this.camera.near = Math.max(this.distance * 0.01, far * 1e-6);
    this.camera.far = far;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    for (const listener of this.#listeners) listener();
  }
}
