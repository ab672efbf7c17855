// Conflict groups: bees that hang together by pairs that are too close.

export interface Group {
  /** As `beespace detect` counts: from 0, in the order of their first bees. */
  number: number;
  bees: number[];
  /** Distance of its closest pair. */
  closest_m: number;
}

export interface Groups {
  /** The largest first; among equals the one with the closest pair. */
  list: Group[];
  /** Place in the list of each bee's group; −1: in none. */
  of: Int32Array;
}

/** Exact: which bee stands for a group does not matter, only which are connected. */
export function findGroups(
  count: number,
  first: Uint32Array,
  second: Uint32Array,
  distance_m: Float64Array,
): Groups {
  const parent = new Int32Array(count).fill(-1);
  const root = (bee: number): number => {
    if (parent[bee] < 0) parent[bee] = bee;
    while (parent[bee] !== bee) {
      parent[bee] = parent[parent[bee]];
      bee = parent[bee];
    }
    return bee;
  };
  for (let i = 0; i < first.length; ++i) {
    const a = root(first[i]);
    const b = root(second[i]);
    if (a !== b) parent[Math.max(a, b)] = Math.min(a, b);
  }

  const byRoot = new Map<number, Group>();
  for (let bee = 0; bee < count; ++bee) {
    if (parent[bee] < 0) continue;
    const top = root(bee);
    const group = byRoot.get(top);
    if (group) group.bees.push(bee);
    else byRoot.set(top, { number: byRoot.size, bees: [bee], closest_m: Infinity });
  }
  for (let i = 0; i < first.length; ++i) {
    const group = byRoot.get(root(first[i])) as Group;
    if (distance_m[i] < group.closest_m) group.closest_m = distance_m[i];
  }

  const list = [...byRoot.values()].sort(
    (a, b) => b.bees.length - a.bees.length || a.closest_m - b.closest_m || a.bees[0] - b.bees[0],
  );
  const of = parent;
  of.fill(-1);
  list.forEach((group, place) => {
    for (const bee of group.bees) of[bee] = place;
  });
  return { list, of };
}
