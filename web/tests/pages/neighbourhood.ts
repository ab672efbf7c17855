// Who is near whom, for the pages of the tests: a grid of cells as wide as the threshold.
export interface Points {
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
}

export interface Found {
  nearest_m: Float64Array;
  pairs: { first: number; second: number; distance_m: number }[];
}

/** The nearest is right up to a cell's width; who has nobody so near gets more than that. */
export function findNear({ x, y, z }: Points, threshold_m: number, cell_m: number): Found {
  const count = x.length;
  const cell = Math.max(cell_m, threshold_m);
  const least = [x, y, z].map((axis) => axis.reduce((a, b) => Math.min(a, b), Infinity));
  const [wide, deep, tall] = [x, y, z].map((axis, i) => Math.floor((axis.reduce((a, b) => Math.max(a, b)) - least[i]) / cell) + 3);
  const keyOf = (i: number): number =>
    Math.floor((x[i] - least[0]) / cell) + 1 +
    wide * (Math.floor((y[i] - least[1]) / cell) + 1 + deep * (Math.floor((z[i] - least[2]) / cell) + 1));
  const heads = new Int32Array(wide * deep * tall).fill(-1);
  const next = new Int32Array(count).fill(-1);
  for (let i = 0; i < count; ++i) {
    const key = keyOf(i);
    next[i] = heads[key];
    heads[key] = i;
  }
  const nearest_m = Float64Array.from({ length: count }, (_, i) => cell * (1 + ((i * 7919) % 1000) / 900));
  const pairs: Found['pairs'] = [];
  const around: number[] = [];
  for (const dz of [-1, 0, 1]) for (const dy of [-1, 0, 1]) for (const dx of [-1, 0, 1]) around.push(dx + wide * (dy + deep * dz));
  for (let i = 0; i < count; ++i) {
    const key = keyOf(i);
    for (const step of around) {
      for (let j = heads[key + step]; j >= 0; j = next[j]) {
        if (j <= i) continue;
        const distance_m = Math.sqrt((x[i] - x[j]) ** 2 + (y[i] - y[j]) ** 2 + (z[i] - z[j]) ** 2);
        if (distance_m < nearest_m[i]) nearest_m[i] = distance_m;
        if (distance_m < nearest_m[j]) nearest_m[j] = distance_m;
        if (distance_m < threshold_m) pairs.push({ first: i, second: j, distance_m });
      }
    }
  }
  pairs.sort((a, b) => a.distance_m - b.distance_m);
  return { nearest_m, pairs };
}
