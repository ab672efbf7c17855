// How many of a large crowd are drawn while it moves: as many as this machine draws in time.

/** Frames that take longer do not feel like movement: twenty a second do. From frames that take less there is room for more. */
const kLongest_ms = 50;
const kShortest_ms = 20;
/** Fewer than so many are never drawn for speed. */
const kFewest = 10000;
/** So many frames have a say before the share changes. */
const kFrames = 3;

export class Pace {
  /** One of so many bees is drawn. */
  every = 1;
  #times_ms: number[] = [];

  constructor(readonly count: number) {}

  /** How long the last frame of movement took. */
  took(frame_ms: number): void {
    this.#times_ms.push(frame_ms);
    if (this.#times_ms.length < kFrames) return;
    const usual_ms = this.#times_ms.sort((a, b) => a - b)[Math.floor(kFrames / 2)];
    this.#times_ms = [];
    // A frame that takes much too long is cut at once by as much.
    if (usual_ms > kLongest_ms) this.every = Math.min(this.#most, this.every * Math.max(2, Math.floor(usual_ms / kLongest_ms)));
    else if (usual_ms < kShortest_ms) this.every = Math.max(1, Math.floor(this.every / 2));
  }

  /** Movement begins anew: what was before does not count. */
  rest(): void {
    this.#times_ms = [];
  }

  get #most(): number {
    return Math.max(1, Math.floor(this.count / kFewest));
  }
}
