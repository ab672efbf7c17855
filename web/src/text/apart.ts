// How far apart two are, horizontally and in height, each below its own limit or not.
import type { Head } from '../data/page';
import { formatFeet } from './heights';
import { formatBelow, formatDigits, formatMetres } from './numbers';

const kNauticalMile_m = 1852;

/** 2.956 NM, and no more digits than it has. */
export function formatMiles(metres: number): string {
  return `${Number((metres / kNauticalMile_m).toPrecision(4))}\u202fNM`;
}

/** 5,475 m, and where the input speaks of feet also 2.956 NM. */
export function formatHorizontal(metres: number, head: Head): string {
  const text = head.vertical_m === undefined ? formatMetres(metres, 4) : formatBelow(metres, head.threshold_m, 4);
  return head.heights?.in_feet ? `${text} · ${formatDigits(metres / kNauticalMile_m, 3)}\u202fNM` : text;
}

/** 91.44 m, and where the input speaks of feet also 300 ft. */
export function formatVertical(metres: number, head: Head): string {
  const text = head.vertical_m === undefined ? formatMetres(metres, 4) : formatBelow(metres, head.vertical_m, 4);
  return head.heights?.in_feet ? `${text} · ${formatFeet(metres, { in_feet: true, by_pressure: false })}` : text;
}
