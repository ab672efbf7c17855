// Bees that are there while it is not known where: a conflict may be hidden then, and that is seen and said.
import type { Recording, Separation } from '../data/recording';
import { drawing } from '../text/element';
import { isolate } from '../text/names';
import { formatCount } from '../text/numbers';
import { counted, nounOf, nounOfAll } from '../text/noun';
import type { Recorded } from './measures';

const kPattern = 'unknown-hatch';
export const kUnknownHere = 'unknown here';
/** What this is told in. */
const kUnknownHere_px = 80;
/** So few are named. */
const kNamed = 2;

/** Who is unknown at this time; at the fixes around a gap a bee is known. */
export function unknownAt({ unknown, fixes }: Recording, within_s: number): number[] {
  return unknown.beesAt(within_s).filter((bee) => !fixes.isThere(bee, within_s));
}

/** "unknown where drone2 is"; nothing where all that are there are known. */
export function unknownText(swarm: Recording, within_s: number): string | null {
  const bees = unknownAt(swarm, within_s);
  if (bees.length === 0) return null;
  const names = bees.map((bee) => isolate(swarm.names.of(bee)));
  const who = bees.length > kNamed ? `${counted(bees.length, nounOf(swarm.head))} are` : `${names.join(' and ')} ${bees.length > 1 ? 'are' : 'is'}`;
  return `unknown where ${who}`;
}

/** Whether one that is unknown may be closer to another than the closest two of the known ones. */
export function isOpenAt({ open }: Separation, within_s: number): boolean {
  for (let i = 0; i < open.begins_s.length && open.begins_s[i] < within_s; ++i) if (within_s < open.ends_s[i]) return true;
  return false;
}

/** In the midst of the longest stretch in which that may be; null where there is none. */
export function longestOpen({ open }: Separation): number | null {
  const lengths = Array.from(open.begins_s, (begins_s, i) => open.ends_s[i] - begins_s);
  const longest = lengths.indexOf(Math.max(...lengths));
  return longest < 0 ? null : open.begins_s[longest] + lengths[longest] / 2;
}

/** In how many stretches of time any is unknown. */
export function unknownStretches({ unknown }: Recording): number {
  const order = Array.from(unknown.begins_s.keys()).sort((a, b) => unknown.begins_s[a] - unknown.begins_s[b]);
  let stretches = 0;
  let until = -Infinity;
  for (const i of order) {
    if (unknown.begins_s[i] > until) ++stretches;
    until = Math.max(until, unknown.ends_s[i]);
  }
  return stretches;
}

/** What the time line is called. */
export function timeName(recorded: Recorded[]): string {
  const stretches = recorded.reduce((sum, { swarm }) => sum + unknownStretches(swarm), 0);
  if (stretches === 0) return 'Time';
  return `Time; in ${stretches === 1 ? 'a stretch' : `${formatCount(stretches)} stretches`} of it not all ${nounOfAll(recorded).several} are known, which is hatched`;
}

/** Once in a drawing, before what is hatched. */
export function hatchPattern(): SVGElement {
  const pattern = drawing('pattern', { id: kPattern, width: 6, height: 6, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)' });
  pattern.append(drawing('line', { class: 'hatch-line', x1: 0, y1: 0, x2: 0, y2: 6 }));
  const definitions = drawing('defs');
  definitions.append(pattern);
  return definitions;
}

export function hatched(x: number, y: number, width: number, height: number): SVGElement {
  return drawing('rect', { class: 'unknown', x, y, width: Math.max(2, width), height, fill: `url(#${kPattern})` });
}

/** Where there is no curve of the closest two, as one may be closer in its gap: said where there is room. */
export function openBands({ open }: Separation, xOf: (time_s: number) => number, from: number, height: number): SVGElement[] {
  return Array.from(open.begins_s).flatMap((begin_s, i) => {
    const [left, right] = [xOf(begin_s), xOf(open.ends_s[i])];
    const words = drawing('text', { class: 'measure unknown-words', x: (left + right) / 2, y: from + height / 2 + 4, 'text-anchor': 'middle' }, kUnknownHere);
    return [hatched(left, from, right - left, height), ...(right - left > kUnknownHere_px ? [words] : [])];
  });
}

/** The columns in which any is unknown, as runs: where each begins, and how wide it is. */
export function runsOf(counts: number[]): [from: number, width: number][] {
  const runs: [number, number][] = [];
  counts.forEach((count, column) => {
    const last = runs[runs.length - 1];
    if (count === 0) return;
    if (last && last[0] + last[1] === column) ++last[1];
    else runs.push([column, 1]);
  });
  return runs;
}
