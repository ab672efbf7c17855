// How far apart two are, horizontally and in height, each below its own limit or not.
import type { Head } from '../data/page';
import { kFoot_m } from './heights';
import { formatBelow, formatCount, formatDigits, formatExactly, formatMetres, formatTick, kSmall_m, kTiny_m, readsBelow } from './numbers';

export const kNauticalMile_m = 1852;

/** 2.956 NM, and no more digits than it has. */
export function formatMiles(metres: number): string {
  return `${Number((metres / kNauticalMile_m).toPrecision(4))}\u202fNM`;
}

/** Of aviation: what is too close is less than a mile, and told in feet. */
function isInFeet({ threshold_m }: Head): boolean {
  return threshold_m < kNauticalMile_m;
}

/** 300 ft; 1.15 ft beside limits of a few feet, and below a limit that it is below. */
function feetBelow(metres: number, limit_m: number, beside_m: number): string {
  const few = beside_m / kFoot_m < 100;
  const text = (value: number, more: number): string => (!few && more === 0 ? formatCount(value) : formatDigits(value, 3 + more));
  return `${readsBelow(metres / kFoot_m, limit_m / kFoot_m, 0, text)}\u202fft`;
}

/** 5,475 m, and of aviation 2.96 NM before it, or 1.15 ft; below the limit in either. */
export function formatHorizontal(metres: number, head: Head): string {
  const limited = head.vertical_m !== undefined;
  const text = limited ? formatBelow(metres, head.threshold_m, 4) : formatMetres(metres, 4);
  if (!head.aviation) return text;
  const limit_m = limited ? head.threshold_m : Infinity;
  if (isInFeet(head)) return `${feetBelow(metres, limit_m, head.threshold_m)} · ${text}`;
  return `${readsBelow(metres / kNauticalMile_m, limit_m / kNauticalMile_m, 3, formatDigits)}\u202fNM · ${text}`;
}

/** 91.44 m, and of aviation 300 ft before it; below the limit in either. */
export function formatVertical(metres: number, head: Head): string {
  const limit_m = head.vertical_m;
  const text = limit_m === undefined ? formatMetres(metres, 4) : formatBelow(metres, limit_m, 4);
  if (!head.aviation) return text;
  // Beside whole feet of a limit that is a flight level or more, millimetres say nothing.
  const metric = (limit_m ?? head.threshold_m) >= 100 && metres < 0.1 ? formatMetres(0) : text;
  return `${feetBelow(metres, limit_m ?? Infinity, limit_m ?? head.threshold_m)} · ${metric}`;
}

/** 1.393 NM, 300 ft: with a vertical threshold both, as short as they are; otherwise the straight line. */
export function formatApart(distance_m: number, apart: { horizontal_m: number; height_m: number } | null, head: Head, digits = 3): string {
  if (head.vertical_m === undefined || !apart || !Number.isFinite(apart.horizontal_m) || !Number.isFinite(apart.height_m)) {
    return formatBelow(distance_m, head.threshold_m, digits);
  }
  // Of two units the first.
  const short = (text: string): string => text.split(' · ')[0];
  return `${short(formatHorizontal(apart.horizontal_m, head))}, ${short(formatVertical(apart.height_m, head))}`;
}

/** The greater of the shares of both thresholds: what conflicts are ordered by; without a vertical threshold the distance. */
export function rankOf(distance_m: number, apart: { horizontal_m: number; height_m: number } | null, head: Head): number {
  if (head.vertical_m === undefined || !apart) return distance_m;
  const share = Math.max(apart.horizontal_m / head.threshold_m, apart.height_m / head.vertical_m);
  return Number.isFinite(share) ? share : Infinity;
}

/** What the axis of a chart is told in: metres, or of aviation nautical miles and feet. */
export interface AxisUnit {
  metres: number;
  text: (value: number) => string;
}

const kInMetres: AxisUnit = { metres: 1, text: (value) => formatTick(Number(value.toPrecision(12))) };

function inUnits(metres: number, name: string): AxisUnit {
  const number = (value: number): string => (Math.abs(value) >= 1000 ? formatCount(value) : String(Number(value.toPrecision(5))));
  return { metres, text: (value) => `${number(value)}\u202f${name}` };
}

/** Metres, or milli- or micrometres where that is how far apart they must be; of aviation feet where that is less than a mile. */
export function lengthUnit(head: Head): AxisUnit {
  if (head.aviation && isInFeet(head)) return inUnits(kFoot_m, 'ft');
  if (head.threshold_m < kTiny_m) return inUnits(1e-6, 'µm');
  return head.threshold_m < kSmall_m ? inUnits(0.001, 'mm') : kInMetres;
}

/** In what lengths of a scene are told: as pictures have them. */
export interface LengthUnits {
  /** Along the ground, of lengths about so long. */
  ground: (length_m: number) => AxisUnit;
  height: AxisUnit;
}

const kMiles: AxisUnit = inUnits(kNauticalMile_m, 'NM');
const kFeet: AxisUnit = inUnits(kFoot_m, 'ft');

/** Metres; of aviation nautical miles, or feet where less than a mile is too close, and heights in feet. */
export function lengthUnits(head: Head): LengthUnits {
  const ofAviation = (length_m: number): AxisUnit => (isInFeet(head) && length_m < 5 * kNauticalMile_m ? kFeet : kMiles);
  return { ground: head.aviation ? ofAviation : () => kInMetres, height: head.aviation || head.heights?.in_feet ? kFeet : kInMetres };
}

export function axisUnits(head: Head): { horizontal: AxisUnit; vertical: AxisUnit } {
  if (!head.aviation) return { horizontal: lengthUnit(head), vertical: lengthUnit(head) };
  return { horizontal: isInFeet(head) ? inUnits(kFoot_m, 'ft') : inUnits(kNauticalMile_m, 'NM'), vertical: inUnits(kFoot_m, 'ft') };
}

/** What they must keep, in the words of those who made the input: 5 NM and 1,000 ft, or metres. */
export function limitsOf(head: Head): { horizontal: string; vertical: string } {
  const vertical_m = head.vertical_m ?? 0;
  if (!head.aviation) return { horizontal: formatExactly(head.threshold_m), vertical: formatExactly(vertical_m) };
  return { horizontal: isInFeet(head) ? formatFeetExactly(head.threshold_m) : formatMiles(head.threshold_m), vertical: formatFeetExactly(vertical_m) };
}

function formatFeetExactly(metres: number): string {
  const feet = Number((metres / kFoot_m).toPrecision(5));
  return `${Number.isInteger(feet) ? formatCount(feet) : feet}\u202fft`;
}
