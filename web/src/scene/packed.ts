// The bees of a moving swarm that are drawn, one after the other: of a large crowd only these go to the graphics card.
import { BufferAttribute, DynamicDrawUsage, type BufferGeometry } from 'three';
import type { Placement } from './placement';

const kAxes = ['x', 'y', 'z'] as const;
/** No bee has this slot. */
const kNowhere = 0xffffffff;
const kFewest = 64;

/** Numbers of slots, with room to spare: where there is none, a larger buffer is a new one on the graphics card. */
class Column<Kind extends Float32Array | Uint16Array> {
  attribute: BufferAttribute;

  constructor(readonly make: (room: number) => Kind) {
    this.attribute = this.#roomFor(0);
  }

  /** An array for at least so many, of which so many are sent. */
  take(count: number): Kind {
    if (this.attribute.array.length < count) this.attribute = this.#roomFor(count);
    this.attribute.clearUpdateRanges();
    this.attribute.addUpdateRange(0, count);
    this.attribute.needsUpdate = true;
    return this.attribute.array as Kind;
  }

  #roomFor(count: number): BufferAttribute {
    const attribute = new BufferAttribute(this.make(Math.max(kFewest, Math.ceil(1.25 * count))), 1);
    attribute.setUsage(DynamicDrawUsage);
    return attribute;
  }
}

export class Packed {
  readonly #slots: Uint32Array;
  #bees: Uint32Array;
  #count = 0;
  readonly #places = kAxes.map(() => new Column((room) => new Float32Array(room)));
  readonly #codes = new Column((room) => new Uint16Array(room));

  constructor(count: number) {
    this.#slots = new Uint32Array(count);
    this.#bees = new Uint32Array(kFewest);
  }

  /** Packs this crowd in its order, and behind it the others that are drawn, each bee once. */
  pack(placement: Placement, crowd: Uint32Array, others: readonly Uint32Array[], codes: Uint16Array | null): void {
    this.#slots.fill(kNowhere);
    this.#count = 0;
    const most = others.reduce((sum, { length }) => sum + length, crowd.length);
    if (this.#bees.length < most) this.#bees = new Uint32Array(Math.ceil(1.25 * most));
    for (const bees of [crowd, ...others]) this.#seat(bees);
    kAxes.forEach((axis, i) => this.#gather(placement[axis], this.#places[i].take(this.#count)));
    if (codes) this.#gather(codes, this.#codes.take(this.#count));
  }

  #seat(bees: Uint32Array): void {
    const slots = this.#slots;
    const seated = this.#bees;
    let count = this.#count;
    for (const bee of bees) {
      if (slots[bee] !== kNowhere) continue;
      slots[bee] = count;
      seated[count++] = bee;
    }
    this.#count = count;
  }

  #gather(from: ArrayLike<number>, into: Float32Array | Uint16Array): void {
    const bees = this.#bees;
    for (let slot = 0; slot < this.#count; ++slot) into[slot] = from[bees[slot]];
  }

  /** Where packed bees are. */
  slotsOf(bees: Uint32Array): Uint32Array {
    return bees.map((bee) => this.#slots[bee]);
  }

  /** Gives the packed numbers to a geometry; those of colours where it has some. */
  giveTo(geometry: BufferGeometry, withCodes: boolean): void {
    kAxes.forEach((axis, i) => {
      if (geometry.getAttribute(axis) !== this.#places[i].attribute) geometry.setAttribute(axis, this.#places[i].attribute);
    });
    if (!withCodes) geometry.deleteAttribute('near');
    else if (geometry.getAttribute('near') !== this.#codes.attribute) geometry.setAttribute('near', this.#codes.attribute);
  }
}
