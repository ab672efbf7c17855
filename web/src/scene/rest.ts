// While a view moves that draws slowly, a part of the crowd must do; all of it is there when it rests.
import type { Cloud } from './cloud';

/** A frame that takes longer than this does not feel as if one held the swarm. */
const kSlow_ms = 90;
/** A view rests when it has not moved for so long; where frames are slow, so are the movements that we hear of. */
const kRest_ms = 250;
const kRestWhereSlow_ms = 800;

export class Rest {
  /** Whether the last frame of the whole crowd was. */
  #slow = false;
  #resting = 0;

  constructor(
    readonly cloud: Cloud,
    readonly invalidate: () => void,
  ) {}

  moved(): void {
    this.cloud.thin(this.#slow);
    clearTimeout(this.#resting);
    this.#resting = window.setTimeout(() => {
      this.#resting = 0;
      this.cloud.thin(false);
      this.invalidate();
    }, this.#slow ? kRestWhereSlow_ms : kRest_ms);
    this.invalidate();
  }

  /** A frame was drawn; the next one comes when it is done. */
  drawn(): void {
    if (this.cloud.isThin) return;
    const begins = performance.now();
    requestAnimationFrame(() => (this.#slow = performance.now() - begins > kSlow_ms));
  }
}
