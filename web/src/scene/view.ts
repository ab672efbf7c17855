// One swarm in three dimensions. It draws when something changed, and rests otherwise.
import { Color, Group, Scene, Vector3, type WebGLRenderer } from 'three';
import type { Fixes } from '../data/fixes';
import type { Nearest } from '../data/nearest';
import type { Triple } from '../data/positions';
import { Axes } from './axes';
import { Orbit } from './camera';
import { Cloud } from './cloud';
import { Compass } from './compass';
import type { Frame } from './frame';
import { Guidance, type Guided } from './guidance';
import { surviveLoss } from './lost_card';
import { Markers } from './markers';
import { Outcasts } from './outcasts';
import type { Palette } from './palette';
import { pickBee } from './picking';
import { placeIn, type Placement } from './placement';
import { ScaleBar } from './scale_bar';
import { ThresholdShape } from './threshold_shape';
import { Trails } from './trails';

/** A frame that takes longer than this does not feel as if one held the swarm. */
const kSlow_ms = 90;
/** A view rests when it has not moved for so long; where frames are slow, so are the movements that we hear of. */
const kRest_ms = 250;
const kRestWhereSlow_ms = 800;

export interface ViewSubject {
  label: string;
  count: number;
  axes: readonly string[];
  /** Whether heights are read in feet. */
  inFeet: boolean;
  threshold_m: number;
  vertical_m: number | null;
  nearest: Nearest | null;
  /** Codes between which the colours change. */
  range: [number, number];
}

export class View {
  readonly orbit: Orbit;
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  /** What is in the swarm's own metres. */
  readonly #lifted = new Group();
  readonly #cloud: Cloud;
  readonly #axes: Axes;
  readonly #threshold: ThresholdShape;
  readonly #trails: Trails;
  readonly #guidance: Guidance;
  readonly #outcasts = new Outcasts();
  readonly #markers = new Markers();
  readonly #scale = new ScaleBar();
  readonly #compass: Compass;
  readonly #drawn: (() => void)[] = [];
  #lift = 1;
  #placement: Placement | null = null;
  #marked: number[] = [];
  #width = 1;
  #height = 1;
  #due = 0;
  #resting = 0;
  /** Whether the last frame of the whole crowd was. */
  #slow = false;

  constructor(
    readonly holder: HTMLElement,
    readonly frame: Frame,
    readonly subject: ViewSubject,
    renderer: WebGLRenderer,
  ) {
    const { count } = subject;
    this.#renderer = renderer;
    this.canvas = renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', `${subject.label} in three dimensions. Arrow keys turn, + and − zoom.`);
    this.orbit = new Orbit(this.canvas, frame);
    this.#cloud = new Cloud(count, frame, subject.nearest, subject.range);
    this.#axes = new Axes(frame, subject.axes, subject.inFeet);
    this.#threshold = new ThresholdShape(subject.threshold_m, subject.vertical_m);
    this.#trails = new Trails(frame);
    this.#trails.hide();
    this.#guidance = new Guidance(frame);
    this.#compass = new Compass(subject.axes);
    this.#lifted.add(this.#axes.group, this.#trails.lines, this.#cloud.group, this.#guidance.group);
    this.#scene.add(this.#lifted, this.#threshold.group, this.#outcasts.rings);
    this.#lift = frame.lift;
    this.#setLift();
    holder.prepend(this.canvas, this.#axes.labels, this.#markers.layer);
    holder.append(this.#scale.box, this.#compass.box);
    this.orbit.onChange(() => this.#moved());
    new ResizeObserver(() => this.#resize()).observe(holder);
    // The pixel ratio changes with the zoom of the browser.
    addEventListener('resize', () => this.#resize());
    this.#resize();
    surviveLoss(this.canvas, holder, () => this.invalidate());
  }

  colour(palette: Palette): void {
    this.#renderer.setClearColor(new Color(palette.ground));
    for (const part of [this.#cloud, this.#axes, this.#threshold, this.#trails, this.#guidance, this.#outcasts]) {
      part.colour(palette);
    }
    this.invalidate();
  }

  /** Heights are drawn so many times larger than they are. */
  lift(times: number): void {
    const by = times / this.#lift;
    // Two views have one frame.
    this.#lift = this.frame.lift = times;
    this.#setLift();
    this.orbit.lifted(by);
    this.#threshold.place(this.#marked.length > 0 ? this.sceneOf(this.#marked[0]) : null);
    this.invalidate();
  }

  #setLift(): void {
    this.#lifted.scale.z = this.frame.lift;
    this.#threshold.lift(this.frame.lift);
  }

  place(placement: Placement): void {
    this.#placement = placement;
    this.#cloud.place(placement);
    this.#threshold.place(this.#marked.length > 0 ? this.sceneOf(this.#marked[0]) : null);
    this.invalidate();
  }

  /** Marks bees; around the first one lies what is too close to it. */
  mark(bees: number[], names: string[]): void {
    this.#marked = bees;
    this.#markers.name(names);
    this.#threshold.place(bees.length > 0 ? this.sceneOf(bees[0]) : null);
    this.invalidate();
  }

  /** The first bee that is marked as its planner has it; null where that is not known. */
  guide(guided: Guided | null): void {
    this.#guidance.show(guided);
    this.invalidate();
  }

  /** Bees that keep their contracts no longer. */
  castOut(bees: number[]): void {
    this.#outcasts.place(bees.map((bee) => this.sceneOf(bee)).filter((place) => place !== null));
    this.invalidate();
  }

  trail(fixes: Fixes, time_s: number, length_s: number): void {
    if (this.#placement?.shown) this.#trails.draw(fixes, this.#placement.shown, time_s, length_s);
    this.invalidate();
  }

  hideTrails(): void {
    this.#trails.hide();
    this.invalidate();
  }

  /** Where the bee is in the scene; null where it is not there now. */
  sceneOf(bee: number): Vector3 | null {
    const placed = this.#placement;
    if (!placed) return null;
    // A bee of a recording is nowhere at times; one of a snapshot is where it is even if filtered out.
    if (placed.x instanceof Float32Array && placed.shown && !placed.shown.includes(bee)) return null;
    return new Vector3(...this.frame.toScene(placeIn(placed, bee)));
  }

  /** Where the bee is as it is drawn, in metres of the axes. */
  placeOf(bee: number): Triple | null {
    return this.#placement && placeIn(this.#placement, bee);
  }

  /** Goes to where these bees fill a part of the view. */
  flyTo(bees: number[], atOnce = false): void {
    const places = bees.map((bee) => this.sceneOf(bee)).filter((place) => place !== null);
    if (places.length === 0) return;
    const middle = new Vector3();
    for (const place of places) middle.addScaledVector(place, 1 / places.length);
    const apart = Math.max(...places.map((place) => place.distanceTo(middle)));
    const { threshold_m, vertical_m } = this.subject;
    const shape = Math.max(threshold_m, (vertical_m ?? 0) * this.frame.lift);
    const reach = Math.max(4 * apart, 3.2 * shape, this.frame.radius * 2e-4);
    this.orbit.flyTo(middle, Math.min(reach * 1.6, this.orbit.homeDistance), atOnce);
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

  /** Where on the canvas a bee is seen. */
  project(bee: number): { x: number; y: number } | null {
    const at = this.sceneOf(bee)?.project(this.orbit.camera);
    return at ? { x: ((at.x + 1) * this.#width) / 2, y: ((1 - at.y) * this.#height) / 2 } : null;
  }

  pick(x: number, y: number): number | null {
    if (!this.#placement) return null;
    const { camera } = this.orbit;
    const toScreen = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
    toScreen.scale(new Vector3(1, 1, this.frame.lift));
    const cursor = { x, y, width: this.#width, height: this.#height };
    return pickBee(cursor, this.#placement, this.frame, toScreen);
  }

  onDrawn(listener: () => void): void {
    this.#drawn.push(listener);
  }

  invalidate(): void {
    if (this.#due !== 0) return;
    this.#due = requestAnimationFrame(() => {
      this.draw();
      if (this.#cloud.isThin) return;
      // The next frame comes when this one is done.
      const begins = performance.now();
      requestAnimationFrame(() => (this.#slow = performance.now() - begins > kSlow_ms));
    });
  }

  /** Draws now. */
  draw(): void {
    cancelAnimationFrame(this.#due);
    this.#due = 0;
    const { camera, distance } = this.orbit;
    const { flatness, homeDistance } = this.orbit;
    this.#cloud.setNearness((homeDistance * flatness) / distance);
    this.#cloud.setSizes(homeDistance * flatness, this.#renderer.getPixelRatio());
    this.#renderer.render(this.#scene, camera);
    this.#axes.letter(camera, this.#width, this.#height);
    this.#markers.move(this.#marked.map((bee) => this.sceneOf(bee)), camera, this.#width, this.#height);
    this.#compass.turn(camera);
    this.#scale.show((2 * distance * Math.tan((camera.fov * Math.PI) / 360)) / this.#height, this.#width, this.frame.lift);
    for (const listener of this.#drawn) listener();
  }

  /** Draws and waits until the graphics card is done. */
  drawAndWait(): void {
    this.draw();
    const gl = this.#renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** While the view moves and drawing is slow, a part of the crowd must do; all of it when it rests. */
  #moved(): void {
    this.#cloud.thin(this.#slow);
    clearTimeout(this.#resting);
    this.#resting = window.setTimeout(() => {
      this.#resting = 0;
      this.#cloud.thin(false);
      this.invalidate();
    }, this.#slow ? kRestWhereSlow_ms : kRest_ms);
    this.invalidate();
  }

  #resize(): void {
    // The new canvas is empty until it is drawn on.
    if (this.measure() && this.#placement) this.draw();
  }

  /** Takes the size that there is room for; says whether it is another one. */
  measure(): boolean {
    const [width, height] = [Math.max(1, this.holder.clientWidth), Math.max(1, this.holder.clientHeight)];
    const ratio = this.subject.count > 50000 ? 1 : Math.min(devicePixelRatio, 2);
    if (width === this.#width && height === this.#height && ratio === this.#renderer.getPixelRatio()) return false;
    [this.#width, this.#height] = [width, height];
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(this.#width, this.#height, false);
    this.orbit.resize(this.#width, this.#height);
    for (const part of [this.#guidance, this.#outcasts]) part.setPixelRatio(this.#renderer.getPixelRatio());
    return true;
  }
}
