// The box around the swarm: a grid on its floor, and metres written along three of its edges.
import { BufferAttribute, BufferGeometry, Group, LineSegments, Vector3 } from 'three';
import type { Camera, RawShaderMaterial } from 'three';
import type { Triple } from '../data/positions';
import type { AxisUnit, LengthUnits } from '../text/apart';
import { element } from '../text/element';
import { niceTicks } from '../text/nice_steps';
import type { Frame } from './frame';
import { shapeMaterial, vectorOf } from './materials';
import type { Palette } from './palette';

interface Tick {
  axis: number;
  metres: number;
  label: HTMLElement;
}

/** At whole ones of what lengths are told in. */
function ticksOf(least: number, most: number, { metres, text }: AxisUnit): { metres: number; text: string }[] {
  return niceTicks(least / metres, most / metres, 5).map((value) => ({ metres: value * metres, text: text(value) }));
}

const kClear_px = 34;
/** Corners where other things are written: the scale bar and the compass; wide and tall. */
const kTaken = { scale: [170, 48], compass: [118, 88] };
/** Where along its edge, and how far from it, a name of an axis may stand: the first that is free. */
const kNamePlaces = [0.5, 0.3, 0.7, 0.15, 0.85, 0, 1].flatMap((along) => [46, 30, -24].map((away) => ({ along, away })));

export class Axes {
  readonly group = new Group();
  readonly labels = element('div', { class: 'axis-labels', 'aria-hidden': 'true' });
  readonly #grid: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #box: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #ticks: Tick[] = [];
  readonly #names: HTMLElement[] = [];

  constructor(
    readonly frame: Frame,
    axes: readonly string[],
    units: LengthUnits,
  ) {
    const { least, most } = frame.box;
    const grid: number[] = [];
    const box: number[] = [];
    const ground = units.ground(Math.max(most[0] - least[0], most[1] - least[1]));
    for (const axis of frame.flat ? [0, 1] : [0, 1, 2]) {
      this.#names.push(element('span', { class: 'axis-name' }, axes[axis]));
      for (const { metres, text } of ticksOf(least[axis], most[axis], axis < 2 ? ground : units.height)) {
        const label = element('span', { class: 'axis-tick' }, text);
        this.#ticks.push({ axis, metres, label });
        if (axis === 2) continue;
        const from: Triple = [...least];
        const to: Triple = [most[0], most[1], least[2]];
        from[axis] = to[axis] = metres;
        grid.push(...this.#fromCentre(from), ...this.#fromCentre(to));
      }
      for (let corner = 0; corner < 8; ++corner) {
        if ((corner >> axis) & 1) continue;
        box.push(...this.#fromCentre(this.#corner(corner)), ...this.#fromCentre(this.#corner(corner | (1 << axis))));
      }
    }
    this.labels.append(...this.#ticks.map((tick) => tick.label), ...this.#names);
    this.#grid = this.#lines(grid);
    this.#box = this.#lines(box);
  }

  colour(palette: Palette): void {
    this.#grid.material.uniforms.colour.value = vectorOf(palette.grid);
    this.#box.material.uniforms.colour.value = vectorOf(palette.box);
  }

  /** Puts the labels beside the edges that are towards the camera. */
  letter(camera: Camera, width: number, height: number): void {
    const at = new Vector3();
    const toPixels = (place: Triple): [number, number, boolean] => {
      at.fromArray(this.frame.toScene(place)).project(camera);
      return [((at.x + 1) * width) / 2, ((1 - at.y) * height) / 2, Math.abs(at.z) <= 1];
    };
    const middle = toPixels([0, 1, 2].map((axis) => this.frame.centre[axis]) as Triple);
    const edges = [0, 1, 2].map((axis) => this.#edgeTowards(axis, camera, toPixels));
    const taken: [number, number][] = [];
    const show = (label: HTMLElement, place: Triple, away: number): boolean => {
      const [x, y, inFront] = toPixels(place);
      const length = Math.hypot(x - middle[0], y - middle[1]) || 1;
      const px = x + ((x - middle[0]) / length) * away;
      const py = y + ((y - middle[1]) / length) * away;
      const [fromRight, fromBottom] = [width - px, height - py];
      const inside =
        inFront &&
        px > 24 &&
        fromRight > 24 &&
        py > 12 &&
        fromBottom > 12 &&
        !(px < kTaken.scale[0] && fromBottom < kTaken.scale[1]) &&
        !(fromRight < kTaken.compass[0] && fromBottom < kTaken.compass[1]);
      const free = taken.every(([tx, ty]) => Math.abs(tx - px) > kClear_px * 1.6 || Math.abs(ty - py) > 16);
      label.hidden = !inside || !free;
      if (label.hidden) return false;
      taken.push([px, py]);
      label.style.transform = `translate(-50%, -50%) translate(${px.toFixed(1)}px, ${py.toFixed(1)}px)`;
      return true;
    };
    this.#names.forEach((name, axis) => {
      const { least, most } = this.frame.box;
      name.hidden = most[axis] === least[axis];
      if (name.hidden) return;
      kNamePlaces.some(({ along, away }) => {
        const place: Triple = [...edges[axis]];
        place[axis] = least[axis] + along * (most[axis] - least[axis]);
        return show(name, place, away);
      });
    });
    for (const { axis, metres, label } of this.#ticks) {
      const place: Triple = [...edges[axis]];
      place[axis] = metres;
      show(label, place, axis === 2 ? 30 : 18);
    }
  }

  /** A corner of the edge along the axis on which labels disturb least. */
  #edgeTowards(axis: number, camera: Camera, toPixels: (place: Triple) => [number, number, boolean]): Triple {
    const { least, most } = this.frame.box;
    const side = (other: number): number =>
      camera.position.getComponent(other) * (other === 1 ? this.frame.up : 1) > 0 ? most[other] : least[other];
    if (axis === 0) return [least[0], side(1), least[2]];
    if (axis === 1) return [side(0), least[1], least[2]];
    // At the side of the picture where the other upright edge of numbers is not.
    const across = ([x, y]: Triple): number => toPixels([x, y, least[2]])[0];
    const other = across([side(0), this.frame.centre[1], least[2]]);
    const corners = [0, 1, 2, 3].map((bits) => this.#corner(bits));
    return corners.reduce((a, b) => (Math.abs(across(b) - other) > Math.abs(across(a) - other) ? b : a));
  }

  #corner(bits: number): Triple {
    const { least, most } = this.frame.box;
    return [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? most : least)[axis]) as Triple;
  }

  /** For what the group of all that is lifted lifts. */
  #fromCentre(place: Triple): Triple {
    return place.map((metres, axis) => metres - this.frame.centre[axis]) as Triple;
  }

  #lines(places: number[]): LineSegments<BufferGeometry, RawShaderMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
    const lines = new LineSegments(geometry, shapeMaterial(false, false));
    lines.frustumCulled = false;
    lines.renderOrder = -1;
    this.group.add(lines);
    return lines;
  }
}
