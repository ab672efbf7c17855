// One swarm in three dimensions. It draws when something changed, and rests otherwise.
import { Group, Scene, Vector3 } from 'three';
import type { Fixes } from '../data/fixes';
import type { Obstacle } from '../data/page';
import type { Triple } from '../data/positions';
import { Axes } from './axes';
import { Orbit } from './camera';
import { Cloud } from './cloud';
import type { Colouring } from './colouring';
import { Compass } from './compass';
import type { Frame } from './frame';
import { GroundLines } from './ground_lines';
import { Guidance, type Guided } from './guidance';
import { surviveLoss } from './lost_card';
import { Markers } from './markers';
import { ObstacleLines } from './obstacle_lines';
import { Outcasts } from './outcasts';
import type { Painter } from './painter';
import { rgb, type Palette } from './palette';
import { placeIn, type Placement } from './placement';
import { Pace } from './pace';
import { Rest } from './rest';
import { Ruler } from './ruler';
import { ScaleBar } from './scale_bar';
import { Sight } from './sight';
import { ThresholdShape } from './threshold_shape';
import { Trails } from './trails';
import type { LengthUnits } from '../text/apart';
import { element } from '../text/element';
import { aheadOf, Vectors } from './vectors';

export interface ViewSubject {
  several: string;
  label: string;
  count: number;
  axes: readonly string[];
  units: LengthUnits;
  threshold_m: number;
  vertical_m: number | null;
  obstacles: Obstacle[];
}

export class View {
  readonly orbit: Orbit;
  /** Between places of the swarm and places on the screen. */
  readonly sight: Sight;
  readonly canvas: HTMLCanvasElement;
  readonly pace: Pace;
  readonly #renderer: Painter;
  readonly #scene = new Scene();
  /** What is in the swarm's own metres. */
  readonly #lifted = new Group();
  readonly #cloud: Cloud;
  readonly #rest: Rest;
  readonly #axes: Axes;
  readonly #threshold: ThresholdShape;
  readonly #trails: Trails;
  readonly ground: GroundLines;
  readonly #obstacles: ObstacleLines;
  readonly #vectors: Vectors;
  readonly #ruler: Ruler;
  readonly #guidance: Guidance;
  readonly #outcasts = new Outcasts();
  readonly #markers = new Markers();
  readonly #share = element('div', { class: 'share-shown', 'aria-hidden': 'true', hidden: '' });
  readonly #scale = new ScaleBar();
  readonly #compass: Compass;
  readonly #drawn: (() => void)[] = [];
  readonly #placed: (() => void)[] = [];
  #lift = 1;
  #ahead_s: number | null = null;
  #placement: Placement | null = null;
  #marked: number[] = [];
  #width = 1;
  #height = 1;
  #due = 0;

  constructor(
    readonly holder: HTMLElement,
    readonly frame: Frame,
    readonly subject: ViewSubject,
    renderer: Painter,
  ) {
    const { count } = subject;
    this.#renderer = renderer;
    this.canvas = renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', `${subject.label} ${frame.flat ? 'from above. Arrow keys move' : 'in three dimensions. Arrow keys turn'}, + and − zoom.`);
    this.orbit = new Orbit(this.canvas, frame);
    this.sight = new Sight(this.orbit, frame);
    this.pace = new Pace(count);
    this.#cloud = new Cloud(count, frame);
    this.#rest = new Rest(this.#cloud, () => this.invalidate());
    this.#axes = new Axes(frame, subject.axes, subject.units);
    this.#threshold = new ThresholdShape(subject.threshold_m, subject.vertical_m);
    this.#trails = new Trails(frame);
    this.#trails.hide();
    this.ground = new GroundLines(frame);
    this.#obstacles = new ObstacleLines(frame, subject.obstacles);
    this.#vectors = new Vectors(frame);
    this.#ruler = new Ruler(frame);
    this.#guidance = new Guidance(frame);
    this.#compass = new Compass(subject.axes, frame.up);
    this.#lifted.add(this.#axes.group, this.ground.group, this.#obstacles.group, this.#trails.lines, this.#cloud.group, this.#vectors.lines, this.#guidance.group, this.#ruler.group);
    this.#scene.add(this.#lifted, this.#threshold.group, this.#outcasts.rings);
    this.#lift = frame.lift;
    this.#setLift();
    holder.prepend(this.canvas, this.#axes.labels, this.#markers.layer);
    holder.append(this.#share, this.#scale.box, this.#compass.box);
    this.orbit.onChange(() => this.#rest.moved());
    new ResizeObserver(() => this.#resize()).observe(holder);
    // The pixel ratio changes with the zoom of the browser.
    addEventListener('resize', () => this.#resize());
    this.#resize();
    surviveLoss(this.canvas, holder, () => this.invalidate());
  }

  colour(palette: Palette): void {
    this.#renderer.setClearColor(...rgb(palette.ground));
    for (const part of [this.#cloud, this.#axes, this.ground, this.#obstacles, this.#threshold, this.#trails, this.#vectors, this.#ruler, this.#guidance, this.#outcasts]) {
      part.colour(palette);
    }
    this.invalidate();
  }

  colourBy(colouring: Colouring): void {
    this.#cloud.colourBy(colouring);
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
    this.#lifted.scale.set(1, this.frame.up, this.frame.lift);
    this.#threshold.lift(this.frame.lift);
  }

  place(placement: Placement): void {
    this.#placement = placement;
    this.#cloud.place(placement);
    this.#threshold.place(this.#marked.length > 0 ? this.sceneOf(this.#marked[0]) : null);
    this.invalidate();
    for (const listener of this.#placed) listener();
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

  /** Where bees came from in so many seconds; null: not shown. */
  trails(fixes: Fixes, time_s: number, length_s: number | null): void {
    if (length_s === null || !this.#placement?.shown) this.#trails.hide();
    else this.#trails.draw(fixes, this.#placement.shown, time_s, length_s);
    this.invalidate();
  }

  /** Lines lead to where bees would be after so many seconds; null: none do. */
  vectors(fixes: Fixes, time_s: number, ahead_s: number | null): void {
    if (ahead_s === null || !this.#placement) this.#vectors.hide();
    else this.#vectors.draw(fixes, this.#placement, time_s, ahead_s);
    this.invalidate();
  }

  /** For a line of a length that is seen. */
  aheadOf(fixes: Fixes): number {
    return (this.#ahead_s ??= aheadOf(fixes, this.frame.radius));
  }

  /** Says that one of so many bees is shown. */
  tellShare(every: number): void {
    this.#share.hidden = every === 1;
    if (every > 1) this.#share.textContent = `1 of ${every} ${this.subject.several} is shown while it plays, and all in conflict`;
  }

  /** The line of the measure tool, between places in metres of the axes. */
  measureLine(ends: Triple[]): void {
    this.#ruler.show(ends);
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
    const shape = Math.max(threshold_m, (vertical_m ?? threshold_m) * this.frame.lift);
    const reach = Math.max(4 * apart, 3.2 * shape, this.frame.radius * 2e-4);
    this.orbit.flyTo(middle, Math.min(reach * 1.6, this.orbit.homeDistance), atOnce);
  }

  /** Where on the canvas a bee is seen. */
  project(bee: number): { x: number; y: number } | null {
    return this.sight.project(this.sceneOf(bee));
  }

  pick(x: number, y: number): number | null {
    return this.#placement && this.sight.pick(x, y, this.#placement);
  }

  /** What stands in the way there. */
  obstacleAt(x: number, y: number): string | null {
    return this.#obstacles.nameAt(x, y, (place) => this.sight.project(place));
  }

  readonly onDrawn = (listener: () => void): number => this.#drawn.push(listener);
  readonly onPlaced = (listener: () => void): number => this.#placed.push(listener);

  invalidate(): void {
    if (this.#due !== 0) return;
    this.#due = requestAnimationFrame(() => {
      this.draw();
      this.#rest.drawn();
    });
  }

  /** Draws now. */
  draw(): void {
    cancelAnimationFrame(this.#due);
    this.#due = 0;
    const { camera, distance, flatness, homeDistance } = this.orbit;
    this.#cloud.setNearness((homeDistance * flatness) / distance);
    this.#cloud.setSizes(homeDistance * flatness, this.#renderer.getPixelRatio());
    this.#cloud.prepare(this.sight.toScreen(), (homeDistance * flatness) / distance);
    this.#renderer.render(this.#scene, camera);
    this.#axes.letter(camera, this.#width, this.#height);
    this.#markers.move(this.#marked.map((bee) => this.sceneOf(bee)), camera, this.#width, this.#height);
    this.#compass.turn(camera);
    this.#scale.show((2 * distance * Math.tan((camera.fov * Math.PI) / 360)) / this.#height, this.#width, this.frame.lift, this.subject.units);
    for (const listener of this.#drawn) listener();
  }

  /** Draws and waits until the graphics card is done. */
  drawAndWait(): void {
    this.draw();
    const gl = this.#renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
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
    this.#renderer.setSize(this.#width, this.#height);
    this.orbit.resize(this.#width, this.#height);
    this.sight.resize(this.#width, this.#height);
    for (const part of [this.#guidance, this.#outcasts, this.#ruler]) part.setPixelRatio(this.#renderer.getPixelRatio());
    return true;
  }
}
