// In which pairs (or conflicts) each bee is.

export class Neighbours {
  readonly #from: Uint32Array;
  readonly #places: Uint32Array;

  constructor(count: number, first: Uint32Array, second: Uint32Array) {
    const from = new Uint32Array(count + 1);
    for (let i = 0; i < first.length; ++i) {
      from[first[i] + 1]++;
      from[second[i] + 1]++;
    }
    for (let bee = 0; bee < count; ++bee) from[bee + 1] += from[bee];
    const next = from.slice();
    const places = new Uint32Array(2 * first.length);
    for (let i = 0; i < first.length; ++i) {
      places[next[first[i]]++] = i;
      places[next[second[i]]++] = i;
    }
    this.#from = from;
    this.#places = places;
  }

  /** Places in the list of pairs; ascending, so the closest first. */
  placesOf(bee: number): Uint32Array {
    return this.#places.subarray(this.#from[bee], this.#from[bee + 1]);
  }
}
