// When each bee is in conflict: spans, ascending by bee, then time, without overlap.

export class Spans {
  /** Bees that have a span, ascending, and where their spans begin. */
  readonly bees: Uint32Array;
  readonly #from: Uint32Array;

  constructor(
    bee: Uint32Array,
    readonly begins_s: Float64Array,
    readonly ends_s: Float64Array,
  ) {
    const bees: number[] = [];
    const from: number[] = [];
    for (let i = 0; i < bee.length; ++i) {
      if (i === 0 || bee[i] !== bee[i - 1]) {
        bees.push(bee[i]);
        from.push(i);
      }
    }
    from.push(bee.length);
    this.bees = Uint32Array.from(bees);
    this.#from = Uint32Array.from(from);
  }

  /** Whether a span of the bee at this place of `bees` covers the time. */
  covers(place: number, time_s: number): boolean {
    let low = this.#from[place];
    let high = this.#from[place + 1];
    const end = high;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.ends_s[middle] < time_s) low = middle + 1;
      else high = middle;
    }
    return low < end && this.begins_s[low] <= time_s;
  }

  /** The bees with a span that covers the time. */
  beesAt(time_s: number): number[] {
    const found: number[] = [];
    for (let place = 0; place < this.bees.length; ++place) {
      if (this.covers(place, time_s)) found.push(this.bees[place]);
    }
    return found;
  }

  /** How long the bee is in conflict altogether. */
  secondsOf(bee: number): number {
    const place = this.bees.indexOf(bee);
    if (place < 0) return 0;
    let sum = 0;
    for (let i = this.#from[place]; i < this.#from[place + 1]; ++i) sum += this.ends_s[i] - this.begins_s[i];
    return sum;
  }
}
