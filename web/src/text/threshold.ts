// What counts as too close, in words.
import type { Head } from '../data/page';
import { formatMiles } from './apart';
import { formatFeet } from './heights';
import { formatExactly } from './numbers';

const kPlainFeet = { in_feet: true, by_pressure: false };

export function tooClose(head: Head): string {
  const threshold = formatExactly(head.threshold_m);
  if (head.vertical_m !== undefined) {
    const vertical = formatExactly(head.vertical_m);
    const text = head.inclusive
      ? `at most ${threshold} apart horizontally and ${vertical} in height`
      : `closer than ${threshold} horizontally and ${vertical} in height`;
    return head.heights?.in_feet ? `${text} (${formatMiles(head.threshold_m)}, ${formatFeet(head.vertical_m, kPlainFeet)})` : text;
  }
  return head.inclusive ? `at most ${threshold} apart` : `closer than ${threshold}`;
}
