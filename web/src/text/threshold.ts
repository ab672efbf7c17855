// What counts as too close, in words.
import type { Head } from '../data/page';
import { limitsOf } from './apart';
import { formatExactly } from './numbers';

/** In the words of those who made the input: 5 NM and 1,000 ft, then in metres. */
export function tooClose(head: Head): string {
  const threshold = formatExactly(head.threshold_m);
  const { horizontal, vertical } = limitsOf(head);
  if (head.vertical_m === undefined) {
    const text = head.inclusive ? `at most ${horizontal} apart` : `closer than ${horizontal}`;
    return head.aviation ? `${text} (${threshold})` : text;
  }
  const text = head.inclusive
    ? `at most ${horizontal} apart horizontally and ${vertical} in height`
    : `closer than ${horizontal} horizontally and ${vertical} in height`;
  return head.aviation ? `${text} (${threshold}, ${formatExactly(head.vertical_m)})` : text;
}
