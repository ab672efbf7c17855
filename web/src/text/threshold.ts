// What counts as too close, in words.
import type { Head } from '../data/page';
import { formatExactly } from './numbers';

export function tooClose(head: Head): string {
  const threshold = formatExactly(head.threshold_m);
  if (head.vertical_m !== undefined) {
    const vertical = formatExactly(head.vertical_m);
    return head.inclusive
      ? `at most ${threshold} apart horizontally and ${vertical} in height`
      : `closer than ${threshold} horizontally and ${vertical} in height`;
  }
  return head.inclusive ? `at most ${threshold} apart` : `closer than ${threshold}`;
}
