// Heights, also in the words of those who fly: feet and flight levels.
import type { HeightWords } from '../data/page';
import { formatCoordinate, formatCount } from './numbers';

export const kFoot_m = 0.3048;

/** Below this there are no flight levels: transition altitudes are higher nearly everywhere. */
const kLowestLevel_ft = 5000;

/** 38,000 ft; of pressure altitudes also the level: FL380. */
export function formatFeet(metres: number, words: HeightWords): string {
  const feet = metres / kFoot_m;
  const text = `${formatCount(feet)}\u202fft`;
  if (!words.by_pressure || feet < kLowestLevel_ft) return text;
  return `${text} · FL${String(Math.round(feet / 100)).padStart(3, '0')}`;
}

/** A height to where the error of the shown position begins, where the input has them in feet, and in metres. */
export function formatHeight(metres: number, error_m: number, words: HeightWords | undefined): string {
  const text = formatCoordinate(metres, error_m);
  return words ? `${formatFeet(metres, words)} · ${text}` : text;
}
