// Where we look from: orbit, pan and zoom by mouse, touch and keys, and flights to a place.
import { MOUSE, PerspectiveCamera, TOUCH, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Triple } from '../data/positions';
import type { Frame } from './frame';

const kFlight_ms = 450;
/** Pixels beside, above and below the swarm, seen from home, for what is written around it. */
const kMargin = { aside: 66, above: 42 };
/** How wide the camera sees: as eyes do; or as from very far, so that heights can be read at their axis. */
const kWide_deg = 40;
const kFlat_deg = 4;

/** All of the swarm, seen in this direction. */
interface Whole {
  direction: Vector3;
  fov_deg: number;
}

/** From the south, a little from the west and from above. */
const kHome: Whole = { direction: new Vector3(-0.45, -1, 0.62).normalize(), fov_deg: kWide_deg };
/** Not quite from above, so that north stays up. */
const kAbove: Whole = { direction: new Vector3(0, -1e-3, 1).normalize(), fov_deg: kFlat_deg };
const kSide: Whole = { direction: new Vector3(0, -1, 0), fov_deg: kFlat_deg };

export interface Pose {
  position: Vector3;
  target: Vector3;
  fov_deg: number;
}

function tangent(fov_deg: number): number {
  return Math.tan((fov_deg * Math.PI) / 360);
}

/** How high what is seen is, half of it, at the target. */
function reachOf({ position, target, fov_deg }: Pose): number {
  return position.distanceTo(target) * tangent(fov_deg);
}

/** Between two poses what is seen grows evenly. */
function between(from: Pose, to: Pose, share: number): Pose {
  const mixed = (a: number, b: number): number => a ** (1 - share) * b ** share;
  const [back, toBack] = [from, to].map(({ position, target }) => position.clone().sub(target).normalize());
  const target = from.target.clone().lerp(to.target, share);
  const fov_deg = mixed(from.fov_deg, to.fov_deg);
  const distance = mixed(reachOf(from), reachOf(to)) / tangent(fov_deg);
  return { position: target.clone().addScaledVector(back.lerp(toBack, share).normalize(), distance), target, fov_deg };
}

export class Orbit {
  readonly camera = new PerspectiveCamera(kWide_deg, 1, 0.1, 1000);
  readonly #controls: OrbitControls;
  readonly #listeners: (() => void)[] = [];
  #flight = 0;
  #home: Pose = { position: new Vector3(0, -1, 0), target: new Vector3(), fov_deg: kWide_deg };
  /** From where all of the swarm is seen; null where the reader looks elsewhere. */
  #whole: Whole | null;
  readonly #usual: Whole;
  #fill = { x: 1, y: 1 };

  constructor(
    canvas: HTMLCanvasElement,
    readonly frame: Frame,
  ) {
    this.camera.up.set(0, 0, 1);
    this.#whole = this.#usual = frame.flat ? kAbove : kHome;
    this.#controls = new OrbitControls(this.camera, canvas);
    this.#controls.zoomToCursor = true;
    this.#controls.zoomSpeed = 1.4;
    if (frame.flat) this.#seeAsOnPaper();
    this.#limit();
    this.#controls.addEventListener('start', () => {
      this.#stop();
      this.#whole = null;
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
    return { position: this.camera.position, target: this.#controls.target, fov_deg: this.camera.fov };
  }

  /** From how much farther away than usual the same is seen. */
  get flatness(): number {
    return tangent(kWide_deg) / tangent(this.camera.fov);
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
    this.#home = this.#fit(this.#usual);
    if (this.#whole) this.look(this.#fit(this.#whole));
  }

  /** What has no heights is a sheet of paper: dragging moves it, and it lies as it lay. */
  #seeAsOnPaper(): void {
    this.#controls.enableRotate = false;
    this.#controls.mouseButtons.LEFT = MOUSE.PAN;
    this.#controls.touches.ONE = TOUCH.PAN;
  }

  /** Takes the pose at once. */
  look(pose: Pose): void {
    if (this.camera.fov !== pose.fov_deg) {
      this.camera.fov = pose.fov_deg;
      this.#limit();
    }
    this.camera.position.copy(pose.position);
    this.#controls.target.copy(pose.target);
    this.#controls.update();
    this.#changed();
  }

  /** Takes over the pose of another view that is linked with this one. */
  follow(pose: Pose): void {
    this.#stop();
    this.#whole = null;
    this.look(pose);
  }

  /** Looks from elsewhere, without a flight. */
  goTo(pose: Pose): void {
    this.#stop();
    this.#whole = null;
    this.look(pose);
  }

  home(): void {
    this.#seeAll(this.#usual);
  }

  /** Heights are drawn larger or smaller now: what was in the middle of the view stays there. */
  lifted(by: number): void {
    this.#limit();
    this.#home = this.#fit(this.#usual);
    if (this.#whole) return this.look(this.#fit(this.#whole));
    const { position, target } = this.pose;
    const rise = (by - 1) * target.z;
    this.look({
      position: position.clone().add(new Vector3(0, 0, rise)),
      target: target.clone().add(new Vector3(0, 0, rise)),
      fov_deg: this.camera.fov,
    });
  }

  lookFromAbove(): void {
    this.#lookFrom(kAbove);
  }

  /** Of what has no heights there is no side view. */
  lookFromSide(): void {
    if (this.frame.flat) return;
    this.#lookFrom(kSide);
  }

  /** At all of the swarm where that is what is seen; otherwise at the same place. */
  #lookFrom(whole: Whole): void {
    if (this.#whole) return this.#seeAll(whole);
    const { direction, fov_deg } = whole;
    const target = this.pose.target.clone();
    const distance = reachOf(this.pose) / tangent(fov_deg);
    this.#fly({ position: target.clone().addScaledVector(direction, distance), target, fov_deg });
  }

  #seeAll(whole: Whole): void {
    this.#fly(this.#fit(whole));
    this.#whole = whole;
  }

  /** Goes to where the place is seen from the distance, in the direction that we look in. */
  flyTo(place: Vector3, distance: number, atOnce = false): void {
    const back = this.camera.position.clone().sub(this.#controls.target).normalize();
    // In a window that is taller than wide, from farther away.
    const reach = Math.max(distance / Math.min(1, this.camera.aspect), this.#controls.minDistance * 2);
    const pose = { position: place.clone().addScaledVector(back, reach), target: place.clone(), fov_deg: kWide_deg };
    // As wide as the same is seen from near by, but from far above.
    if (this.frame.flat) Object.assign(pose, { position: place.clone().addScaledVector(kAbove.direction, reachOf(pose) / tangent(kFlat_deg)), fov_deg: kFlat_deg });
    if (atOnce) this.goTo(pose);
    else this.#fly(pose);
  }

  turn(aside: number, up: number): void {
    // Keys that turn elsewhere move the sheet.
    if (this.frame.flat) return this.shift(0.06 * Math.sign(aside), 0.06 * Math.sign(up));
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
    const reach = 2 * reachOf(this.pose);
    const move = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * reach);
    move.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * reach);
    this.#moveTo(this.camera.position.clone().add(move), this.#controls.target.clone().add(move));
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.#controls.target).multiplyScalar(1 / factor);
    this.#moveTo(this.#controls.target.clone().add(offset), this.#controls.target);
  }

  #limit(): void {
    this.#controls.minDistance = this.frame.radius * 1e-5;
    this.#controls.maxDistance = this.frame.radius * 20 * this.flatness;
  }

  #moveTo(position: Vector3, target: Vector3): void {
    this.#stop();
    this.#whole = null;
    this.look({ position, target, fov_deg: this.camera.fov });
  }

  /** From where, in this direction, the box fills the view; found in a few steps. */
  #fit({ direction, fov_deg }: Whole): Pose {
    const right = new Vector3(0, 0, 1).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const tall = tangent(fov_deg);
    const wide = tall * this.camera.aspect;
    const { box, radius } = this.frame;
    // Where all are at one place, there is room for what is too close to them.
    const around = box.most.every((most, axis) => most === box.least[axis]) ? radius : 0;
    const corners = Array.from({ length: 8 }, (_, bits) => {
      const corner = [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? box.most[axis] + around : box.least[axis] - around)) as Triple;
      const at = new Vector3(...this.frame.toScene(corner));
      return { right: at.dot(right), up: at.dot(up), towards: at.dot(direction) };
    });
    const flatness = tangent(kWide_deg) / tall;
    let [distance, aside, above] = [2.5 * radius * flatness, 0, 0];
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
      distance = Math.max(0.4 * radius * flatness, distance * Math.min(2, Math.max(0.5, 0.3 + 0.7 * filled)));
    }
    const target = new Vector3().addScaledVector(right, aside).addScaledVector(up, above);
    return { position: target.clone().addScaledVector(direction, distance), target, fov_deg };
  }

  #fly(to: Pose): void {
    this.#stop();
    this.#whole = null;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.look(to);
      return;
    }
    const from = { position: this.camera.position.clone(), target: this.#controls.target.clone(), fov_deg: this.camera.fov };
    const begins = performance.now();
    const step = (now: number): void => {
      const share = Math.min(1, Math.max(0, (now - begins) / kFlight_ms));
      const eased = share * share * (3 - 2 * share);
      this.look(share < 1 ? between(from, to, eased) : to);
      if (share < 1) this.#flight = requestAnimationFrame(step);
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
