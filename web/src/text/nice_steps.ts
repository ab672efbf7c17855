// Steps that people count in: 1, 2 and 5 with zeros.

/** The largest step of at most this. */
export function niceBelow(most: number): number {
  const ten = 10 ** Math.floor(Math.log10(most));
  for (const digit of [5, 2]) if (digit * ten <= most * (1 + 1e-12)) return digit * ten;
  return ten;
}

/** The smallest step of at least this. */
export function niceAbove(least: number): number {
  const ten = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5].find((digit) => digit * ten >= least * (1 - 1e-12)) ?? 10) * ten;
}

/** Multiples of a nice step within the range, about as many as wanted. */
export function niceTicks(least: number, most: number, wanted: number): number[] {
  if (!(most > least) || !Number.isFinite(most - least)) return [];
  let step = niceBelow((most - least) / wanted);
  if ((most - least) / step > 1.8 * wanted) step = niceBelow(2.6 * step);
  // Where numbers are so great that steps vanish in their last digits, there are none to count in.
  if (Math.max(Math.abs(least), Math.abs(most)) / step > 1e13) return [];
  const ticks: number[] = [];
  for (let i = Math.ceil(least / step - 1e-9); i * step <= most + 1e-9 * step; ++i) {
    ticks.push(Number((i * step).toPrecision(15)));
  }
  return ticks;
}
