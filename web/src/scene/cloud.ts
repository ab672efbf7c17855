// The swarm itself: all bees as points, those at risk once more on top, lines between pairs that are too close.
// The three share their positions on the graphics card and differ in which bees they draw. Of bees that rest all are there;
// of those that move only the ones that are drawn, anew with every moment.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, LineSegments, Matrix4, Points } from 'three';
import type { RawShaderMaterial } from 'three';
import type { Colouring } from './colouring';
import { InSight } from './in_sight';
import { crowdMaterial, lineMaterial, riskMaterial, vectorOf } from './materials';
import type { Frame } from './frame';
import { Packed } from './packed';
import type { Palette } from './palette';
import type { Placement } from './placement';

/** So many at most are drawn while the view moves, where drawing all is slow. */
const kThinned = 120000;

/** From so much nearer than where all is seen it is worth to look who is in sight; of a few all are drawn. */
const kNear = 1.5;
const kFew = 5000;

/** Sizes in pixels, as seen from where the whole swarm is in sight. */
function baseSizes(count: number): { crowd: number; risk: number } {
  if (count > 300000) return { crowd: 1, risk: 1.5 };
  if (count > 50000) return { crowd: 1.5, risk: 3 };
  if (count > 5000) return { crowd: 2.5, risk: 6 };
  return { crowd: 5, risk: 10 };
}

/** Colours from the first to the last one of a scale. */
export function rampOf(colouring: Colouring | null, palette: Palette): string[] {
  if (colouring?.by === 'group') return [palette.plain, ...palette.groups];
  return colouring?.codes ? palette.ramp : palette.ramp.map(() => palette.plain);
}

export class Cloud {
  readonly group = new Group();
  readonly #crowd: Points<BufferGeometry, RawShaderMaterial>;
  readonly #risk: Points<BufferGeometry, RawShaderMaterial>;
  readonly #lines: LineSegments<BufferGeometry, RawShaderMaterial>;
  readonly #count: number;
  #placed: Placement | null = null;
  #colouring: Colouring | null = null;
  #palette: Palette | null = null;
  #thin = false;
  /** Whether other bees are to be drawn than were. */
  #stale = true;
  #inSight: InSight | null = null;
  #culled = false;
  readonly #seenFrom = new Matrix4();
  /** Of a swarm that moves. */
  #packed: Packed | null = null;

  constructor(
    count: number,
    readonly frame: Frame,
  ) {
    this.#count = count;
    this.#crowd = new Points(new BufferGeometry(), crowdMaterial());
    this.#risk = new Points(new BufferGeometry(), riskMaterial());
    this.#lines = new LineSegments(new BufferGeometry(), lineMaterial());
    [this.#crowd, this.#lines, this.#risk].forEach((part, order) => {
      part.frustumCulled = false;
      part.renderOrder = order;
      this.group.add(part);
    });
  }

  place(placement: Placement): void {
    if (this.#placed?.x !== placement.x) this.#setPositions(placement);
    this.#placed = placement;
    this.#stale = true;
    // Where very many lie over one another, their number is visible too, and the bees behind them.
    this.#risk.material.uniforms.opacity.value = Math.min(1, Math.sqrt(20000 / placement.atRisk.length));
  }

  get isThin(): boolean {
    return this.#thin;
  }

  /** Draws only a part of a large crowd, for as long as the view moves; those at risk all the same. */
  thin(on: boolean): void {
    if (this.#count <= kThinned || on === this.#thin) return;
    this.#thin = on;
    this.#stale = true;
  }

  /** Before it is drawn: from near by only what is in sight. `nearness` is 1 where all of the swarm is seen, and grows. */
  prepare(toScreen: Matrix4, nearness: number): void {
    const placed = this.#placed;
    const culled = nearness > kNear && this.#count > kFew;
    if (!placed || (!this.#stale && !culled && !this.#culled)) return;
    if (!this.#stale && culled && this.#culled && this.#seenFrom.equals(toScreen)) return;
    this.#stale = false;
    this.#culled = culled;
    this.#seenFrom.copy(toScreen);
    if (culled) {
      this.#inSight ??= new InSight(this.#count);
      this.#inSight.look(placed, this.frame, toScreen);
    }
    const seen = culled ? this.#inSight : null;
    const crowd = this.#thinned(seen ? seen.of(placed.shown) : placed.shown);
    const risk = seen ? seen.of(placed.atRisk) : placed.atRisk;
    const lines = seen ? seen.ofLines(placed.lines) : placed.lines;
    if (this.#packed && crowd) {
      this.#drawPacked(this.#packed, placed, crowd, risk, lines);
      return;
    }
    this.#draw(this.#crowd.geometry, crowd, this.#count);
    this.#draw(this.#risk.geometry, risk, 0);
    this.#draw(this.#lines.geometry, lines, 0);
  }

  /** Of these bees, or of all, the part that is drawn while the view moves. */
  #thinned(bees: Uint32Array | null): Uint32Array | null {
    const all = bees ? bees.length : this.#count;
    const stride = this.#thin ? Math.ceil(all / kThinned) : 1;
    if (stride === 1) return bees;
    return Uint32Array.from({ length: Math.ceil(all / stride) }, (_, i) => (bees ? bees[i * stride] : i * stride));
  }

  #drawPacked(packed: Packed, placed: Placement, crowd: Uint32Array, risk: Uint32Array, lines: Uint32Array): void {
    const codes = this.#colouring?.codes ?? null;
    packed.pack(placed, crowd, [risk, lines], codes);
    for (const { geometry } of [this.#crowd, this.#risk]) packed.giveTo(geometry, codes !== null);
    packed.giveTo(this.#lines.geometry, false);
    // The crowd comes first, in its order.
    this.#draw(this.#crowd.geometry, null, crowd.length);
    this.#draw(this.#risk.geometry, packed.slotsOf(risk), 0);
    this.#draw(this.#lines.geometry, packed.slotsOf(lines), 0);
  }

  /** Colours of other meaning. Those at risk keep theirs, but for the colours of groups, which are theirs alone. */
  colourBy(colouring: Colouring): void {
    this.#colouring = colouring;
    const { codes, range } = colouring;
    this.#stale = true;
    const attribute = codes && !this.#packed ? new BufferAttribute(codes, 1) : null;
    for (const part of [this.#crowd, this.#risk]) {
      if (attribute) part.geometry.setAttribute('near', attribute);
      else part.geometry.deleteAttribute('near');
      part.material.uniforms.range.value = [range[0], 1 / (range[1] - range[0] || 1)];
    }
    this.#risk.material.uniforms.ramped.value = colouring.by === 'group' ? 1 : 0;
    if (this.#palette) this.colour(this.#palette);
  }

  colour(palette: Palette): void {
    this.#palette = palette;
    const ramp = rampOf(this.#colouring, palette).map(vectorOf);
    for (const part of [this.#crowd, this.#risk]) part.material.uniforms.ramp.value = ramp;
    this.#risk.material.uniforms.fill.value = vectorOf(palette.risk);
    this.#risk.material.uniforms.edge.value = vectorOf(palette.riskEdge);
    this.#lines.material.uniforms.colour.value = vectorOf(palette.line);
  }

  /** Very many lines are faint from afar and clear from near by; `nearness` is 1 at home. */
  setNearness(nearness: number): void {
    const many = (this.#placed?.lines.length ?? 0) > 40000;
    this.#lines.material.uniforms.opacity.value = many ? Math.min(0.8, 0.1 * nearness) : 0.8;
  }

  /** Points grow as one comes near; `homeDistance` is from where all of the swarm is seen. */
  setSizes(homeDistance: number, pixelRatio: number): void {
    const { crowd, risk } = baseSizes(this.#count);
    const set = (part: Points<BufferGeometry, RawShaderMaterial>, size: number, least: number, most: number): void => {
      part.material.uniforms.reach.value = size * homeDistance * pixelRatio;
      part.material.uniforms.sizes.value = [least * pixelRatio, most * pixelRatio];
    };
    set(this.#crowd, crowd, Math.min(1, crowd), Math.max(8, crowd));
    set(this.#risk, risk, Math.min(2, risk), Math.max(13, risk));
  }

  #setPositions(placement: Placement): void {
    const parts = [this.#crowd, this.#risk, this.#lines];
    for (const part of parts) {
      const { uniforms } = part.material;
      uniforms.start.value.fromArray(placement.start.map((start, axis) => start - this.frame.centre[axis]));
      uniforms.stride.value.fromArray(placement.step);
    }
    if (placement.x instanceof Float32Array) {
      this.#packed = new Packed(this.#count);
      return;
    }
    for (const axis of ['x', 'y', 'z'] as const) {
      const attribute = new BufferAttribute(placement[axis], 1);
      for (const part of parts) part.geometry.setAttribute(axis, attribute);
    }
  }

  #draw(geometry: BufferGeometry, bees: Uint32Array | null, all: number): void {
    if (bees) {
      const index = geometry.getIndex();
      if (index && index.array.length >= bees.length && index.array.length > 0) {
        if (index.array !== bees) {
          (index.array as Uint32Array).set(bees);
          index.needsUpdate = true;
        }
      } else {
        // Its own copy with room to spare: a larger one is a new buffer on the graphics card.
        const room = new Uint32Array(Math.max(64, Math.ceil(1.25 * bees.length)));
        room.set(bees);
        const fresh = new BufferAttribute(room, 1);
        fresh.setUsage(DynamicDrawUsage);
        geometry.setIndex(fresh);
      }
    } else {
      geometry.setIndex(null);
    }
    geometry.setDrawRange(0, bees ? bees.length : all);
  }
}
