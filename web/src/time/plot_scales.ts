// How high curves and columns of the time line are.

/** How many bees are in conflict, for each of `columns` equal parts of the clock's time. */
export function conflictColumns(
  begins_s: Float64Array,
  ends_s: Float64Array,
  shift_s: number,
  duration_s: number,
  columns: number,
): number[] {
  const changes = new Array<number>(columns + 1).fill(0);
  const columnOf = (time: number): number =>
    Math.min(columns - 1, Math.max(0, Math.floor(((time + shift_s) / duration_s) * columns)));
  for (let i = 0; i < begins_s.length; ++i) {
    changes[columnOf(begins_s[i])]++;
    changes[columnOf(ends_s[i]) + 1]--;
  }
  let now = 0;
  return changes.slice(0, columns).map((change) => (now += change));
}

/** Height of the plot: the threshold is well seen, and rare great distances do not flatten the rest. */
export function plotTop(distances: number[], threshold_m: number): number {
  if (distances.length === 0) return 2 * threshold_m || 1;
  const sorted = distances.slice().sort((a, b) => a - b);
  const usual = sorted[Math.floor(0.9 * (sorted.length - 1))];
  return Math.max(1.6 * threshold_m, Math.min(1.15 * usual, 12 * threshold_m || Infinity)) || 1;
}
