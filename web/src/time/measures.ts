// What the time line shows of how far apart bees are: a distance, or with a vertical threshold two.
import type { Recording } from '../data/recording';
import type { Shown } from '../panels/shown';
import { axisUnits, lengthUnit, type AxisUnit } from '../text/apart';

export type Recorded = Shown & { swarm: Recording };

/** A curve and its limit. */
export interface Measure {
  name: string;
  limit_m: number;
  unit: AxisUnit;
  of: (swarm: Recording) => Float64Array;
}

/** With a vertical threshold horizontally and in height, each with its own limit; of those who are nearest to a conflict. */
export function measuresOf(recorded: Recorded[]): Measure[] {
  const limit = (of: 'threshold_m' | 'vertical_m'): number => Math.max(...recorded.map(({ swarm }) => swarm.head[of] ?? 0));
  if (!recorded.every(({ swarm }) => swarm.separation.apart)) {
    return [{ name: 'closest two', limit_m: limit('threshold_m'), unit: lengthUnit(recorded[0].swarm.head), of: ({ separation }) => separation.distance_m }];
  }
  const none = new Float64Array(0);
  const { horizontal, vertical } = axisUnits(recorded[0].swarm.head);
  return [
    {
      name: 'nearest to a conflict, horizontally',
      limit_m: limit('threshold_m'),
      unit: horizontal,
      of: ({ separation }) => separation.apart?.horizontal_m ?? none,
    },
    {
      name: 'in height',
      limit_m: limit('vertical_m'),
      unit: vertical,
      of: ({ separation }) => separation.apart?.height_m ?? none,
    },
  ];
}
