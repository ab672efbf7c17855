// How far apart pairs are horizontally and in height.
import { readMeasures } from './column';
import type { ApartPlaces } from './page';

export interface Apart {
  horizontal_m: Float64Array;
  height_m: Float64Array;
}

export async function readApart({ horizontal_m, height_m }: ApartPlaces): Promise<Apart | null> {
  if (!horizontal_m || !height_m) return null;
  return { horizontal_m: await readMeasures(horizontal_m), height_m: await readMeasures(height_m) };
}
