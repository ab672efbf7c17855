// How fast the bees of a recording fly: what scales of speed and the lengths of velocity vectors go by.
import type { Fixes } from './fixes';

const kSamples = 20000;

export interface Speeds {
  /** Of ten bees at any time, nine are not faster. */
  usual_mps: number;
  most_mps: number;
}

/** From stretches between fixes, evenly chosen where there are very many. */
export function speedsOf(fixes: Fixes): Speeds {
  const all = fixes.time.raw.length;
  const stride = Math.max(1, Math.floor(all / kSamples));
  const speeds: number[] = [];
  const velocity: [number, number, number] = [0, 0, 0];
  for (let bee = 0; bee < fixes.bees; ++bee) {
    const first = fixes.firstOf(bee);
    const end = first + fixes.countOf(bee);
    for (let fix = Math.ceil(first / stride) * stride; fix < end; fix += stride) {
      if (fixes.velocity(bee, fixes.timeOf(fix), velocity)) speeds.push(Math.hypot(...velocity));
    }
  }
  const sorted = Float64Array.from(speeds).sort();
  const at = (share: number): number => sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
  return { usual_mps: at(0.9), most_mps: at(0.99) };
}
