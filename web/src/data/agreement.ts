// The parts of a page must fit each other; where they do not, it was changed on its way.

export function agree(fits: boolean, what: string): void {
  if (!fits) throw new Error(`its numbers of ${what} contradict each other`);
}

interface PairLists {
  first: Uint32Array;
  second: Uint32Array;
  distance_m: Float64Array;
}

export function agreeOnPairs({ first, second, distance_m }: PairLists, bees: number): void {
  agree(first.length === second.length && first.length === distance_m.length, 'pairs');
  agree([first, second].every((list) => list.every((bee) => bee < bees)), 'pairs');
}
