// The time that is shown: set, stepped or played.
import { Signal } from '../state/signal';

export const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600];

/** The speed at which the whole takes about half a minute. */
export function speedFor(duration_s: number): number {
  return kSpeeds.find((speed) => duration_s / speed <= 40) ?? kSpeeds[kSpeeds.length - 1];
}

/** From one time to another, and slower near the middle. */
interface Replay {
  middle_s: number;
  ends_s: number;
  slow_s: number;
  speed: number;
}

/** So long a replay takes, without what is slow of it. */
const kReplay_s = 10;
const kSlower = 4;

export class Clock {
  readonly time: Signal<number>;
  readonly playing = new Signal(false);
  readonly speed: Signal<number>;
  #frame = 0;
  #poster_s: number | null = null;
  #replay: Replay | null = null;

  constructor(
    readonly begins_s: number,
    readonly ends_s: number,
    readonly step_s: number,
  ) {
    this.time = new Signal(begins_s);
    this.speed = new Signal(speedFor(ends_s - begins_s));
  }

  go(time_s: number): void {
    this.#poster_s = null;
    this.time.set(Math.min(this.ends_s, Math.max(this.begins_s, time_s)));
  }

  /** Shows this moment until time moves, as a film shows its poster: it plays from the beginning. */
  showPoster(time_s: number): void {
    this.go(time_s);
    this.#poster_s = this.time.value;
  }

  step(steps: number): void {
    this.pause();
    this.go(this.time.value + steps * this.step_s);
  }

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  play(): void {
    if (this.playing.value || this.ends_s <= this.begins_s) return;
    if (this.time.value >= this.ends_s || this.#poster_s !== null) this.go(this.begins_s);
    this.playing.set(true);
    let before = performance.now();
    const tick = (now: number): void => {
      if (!this.playing.value) return;
      // A page that was asleep goes on where it was.
      const elapsed = Math.min(0.5, Math.max(0, (now - before) / 1000));
      before = now;
      const ends_s = this.#replay?.ends_s ?? this.ends_s;
      this.go(Math.min(ends_s, this.time.value + elapsed * this.#speedNow()));
      if (this.time.value >= ends_s) this.pause();
      else this.#frame = requestAnimationFrame(tick);
    };
    this.#frame = requestAnimationFrame(tick);
  }

  /** Plays from one time to another, slowly for so long around the middle; then it rests. */
  replay(begins_s: number, ends_s: number, slow_s: number): void {
    this.pause();
    this.go(begins_s);
    this.#replay = { middle_s: (begins_s + ends_s) / 2, ends_s: Math.min(ends_s, this.ends_s), slow_s, speed: (ends_s - begins_s) / kReplay_s };
    this.play();
  }

  #speedNow(): number {
    if (!this.#replay) return this.speed.value;
    const { middle_s, slow_s, speed } = this.#replay;
    return Math.abs(this.time.value - middle_s) < slow_s ? speed / kSlower : speed;
  }

  pause(): void {
    this.#replay = null;
    cancelAnimationFrame(this.#frame);
    this.playing.set(false);
  }

  changeSpeed(places: number): void {
    const at = kSpeeds.indexOf(this.speed.value);
    this.speed.set(kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, at + places))]);
  }
}
