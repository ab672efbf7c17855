// Speeds, also in the words of those who fly: knots, and feet a minute.
import type { HeightWords } from '../data/page';
import { kFoot_m } from './heights';
import { formatCount, formatDigits } from './numbers';

export const kKnot_mps = 0.514444;
export const kFootAMinute_mps = kFoot_m / 60;

/** 231 m/s, and where the input speaks of feet 449 kt before it. */
export function formatSpeed(metresPerSecond: number, words: HeightWords | undefined): string {
  const text = `${formatDigits(metresPerSecond, 3)}\u202fm/s`;
  return words?.in_feet ? `${formatDigits(metresPerSecond / kKnot_mps, 3)}\u202fkt · ${text}` : text;
}

/** The same upwards: 1,000 ft/min before 5.08 m/s. */
export function formatClimb(metresPerSecond: number, words: HeightWords | undefined): string {
  const text = `${formatDigits(metresPerSecond, 3)}\u202fm/s`;
  return words?.in_feet ? `${formatCount(metresPerSecond / kFootAMinute_mps)}\u202fft/min · ${text}` : text;
}
