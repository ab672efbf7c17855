// How far apart two are, horizontally and in height, each below its own limit or not.
import type { Head } from '../data/page';
import { kFoot_m } from './heights';
import { formatBelow, formatCount, formatDigits, formatExactly, formatMetres, formatTick, kSmall_m, readsBelow } from './numbers';

export const kNauticalMile_m = 1852;

/** 2.956 NM, and no more digits than it has. */
export function formatMiles(metres: number): string {
  return `${Number((metres / kNauticalMile_m).toPrecision(4))}\u202fNM`;
}

/** 5,475 m, and where the input speaks of feet 2.96 NM before it; below the limit in either. */
export function formatHorizontal(metres: number, head: Head): string {
  const limited = head.vertical_m !== undefined;
  const text = limited ? formatBelow(metres, head.threshold_m, 4) : formatMetres(metres, 4);
  if (!head.heights?.in_feet) return text;
  const limit = limited ? head.threshold_m / kNauticalMile_m : Infinity;
  return `${readsBelow(metres / kNauticalMile_m, limit, 3, formatDigits)}\u202fNM · ${text}`;
}

/** 91.44 m, and where the input speaks of feet 300 ft before it; below the limit in either. */
export function formatVertical(metres: number, head: Head): string {
  const limit_m = head.vertical_m;
  const text = limit_m === undefined ? formatMetres(metres, 4) : formatBelow(metres, limit_m, 4);
  if (!head.heights?.in_feet) return text;
  const feet = metres / kFoot_m;
  const whole = (value: number, more: number): string => (more === 0 ? formatCount(value) : formatDigits(value, 3 + more));
  return `${readsBelow(feet, (limit_m ?? Infinity) / kFoot_m, 0, whole)}\u202fft · ${text}`;
}

/** What the axis of a chart is told in: metres, or where the input speaks of feet nautical miles and feet. */
export interface AxisUnit {
  metres: number;
  text: (value: number) => string;
}

const kInMetres: AxisUnit = { metres: 1, text: (value) => formatTick(Number(value.toPrecision(12))) };

function inUnits(metres: number, name: string): AxisUnit {
  const number = (value: number): string => (Math.abs(value) >= 1000 ? formatCount(value) : String(Number(value.toPrecision(5))));
  return { metres, text: (value) => `${number(value)}\u202f${name}` };
}

/** Metres, or millimetres where that is how far apart they must be. */
export function lengthUnit(head: Head): AxisUnit {
  return head.threshold_m < kSmall_m ? inUnits(0.001, 'mm') : kInMetres;
}

export function axisUnits(head: Head): { horizontal: AxisUnit; vertical: AxisUnit } {
  if (!head.heights?.in_feet) return { horizontal: lengthUnit(head), vertical: lengthUnit(head) };
  return { horizontal: inUnits(kNauticalMile_m, 'NM'), vertical: inUnits(kFoot_m, 'ft') };
}

/** What they must keep, in the words of those who made the input: 5 NM and 1,000 ft, or metres. */
export function limitsOf(head: Head): { horizontal: string; vertical: string } {
  const vertical_m = head.vertical_m ?? 0;
  if (!head.heights?.in_feet) return { horizontal: formatExactly(head.threshold_m), vertical: formatExactly(vertical_m) };
  const feet = Number((vertical_m / kFoot_m).toPrecision(5));
  return { horizontal: formatMiles(head.threshold_m), vertical: `${Number.isInteger(feet) ? formatCount(feet) : feet}\u202fft` };
}
