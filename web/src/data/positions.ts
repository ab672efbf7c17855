// Positions as they are kept: three arrays and how to get metres from them.
import { readColumn, type ColumnPlace, type Numbers } from './column';

export type Triple = [number, number, number];

/** Where number r of an axis is: start + step × r, in metres. */
export interface Positions {
  x: Numbers;
  y: Numbers;
  z: Numbers;
  start: Triple;
  step: Triple;
}

export interface Box {
  least: Triple;
  most: Triple;
}

export async function readPositions(places: Record<'x' | 'y' | 'z', ColumnPlace>): Promise<Positions> {
  const [x, y, z] = await Promise.all([readColumn(places.x), readColumn(places.y), readColumn(places.z)]);
  return {
    x: x.raw,
    y: y.raw,
    z: z.raw,
    start: [x.offset, y.offset, z.offset],
    step: [x.scale, y.scale, z.scale],
  };
}

export function positionOf(positions: Positions, place: number): Triple {
  const { x, y, z, start, step } = positions;
  return [start[0] + step[0] * x[place], start[1] + step[1] * y[place], start[2] + step[2] * z[place]];
}

export function boxAround(positions: Positions): Box {
  const box: Box = { least: [0, 0, 0], most: [0, 0, 0] };
  [positions.x, positions.y, positions.z].forEach((numbers, axis) => {
    if (numbers.length === 0) return;
    let least = numbers[0];
    let most = numbers[0];
    for (let i = 1; i < numbers.length; ++i) {
      const number = numbers[i];
      if (number < least) least = number;
      else if (number > most) most = number;
    }
    const ends = [least, most].map((end) => positions.start[axis] + positions.step[axis] * end);
    box.least[axis] = Math.min(...ends);
    box.most[axis] = Math.max(...ends);
  });
  return box;
}

export function boxOfBoth(a: Box, b: Box): Box {
  const pick = (choose: (...ends: number[]) => number, end: 'least' | 'most'): Triple => [
    choose(a[end][0], b[end][0]),
    choose(a[end][1], b[end][1]),
    choose(a[end][2], b[end][2]),
  ];
  return { least: pick(Math.min, 'least'), most: pick(Math.max, 'most') };
}
