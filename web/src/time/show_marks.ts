// What a drone show says of itself on the time line: its cues, and when its limits are exceeded.
import { drawing } from '../text/element';
import { isolate } from '../text/names';
import type { Recorded } from './measures';
import { conflictColumns } from './plot_scales';

const kLetter_px = 5.8;

/** A line at each cue that lies in the time, and its name where there is room. */
export function cueMarks(recorded: Recorded[], xOf: (shown: Recorded, time_s: number) => number, room: { left: number; right: number; top: number; bottom: number }): SVGElement[] {
  const lines: SVGElement[] = [];
  const texts: SVGElement[] = [];
  let taken = -Infinity;
  for (const shown of recorded) {
    const { cues = [], time } = shown.swarm.head;
    for (const { time_s, name } of [...cues].sort((a, b) => a.time_s - b.time_s)) {
      if (time_s < 0 || time_s > time.ends_s - time.begins_s) continue;
      const x = xOf(shown, time_s);
      lines.push(drawing('line', { class: 'cue', x1: x, x2: x, y1: room.top, y2: room.bottom }));
      const text = isolate(name, 16);
      const wide = kLetter_px * Math.min(18, name.length);
      const from = Math.min(x + 3, room.right - wide);
      if (from < taken || from < room.left) continue;
      taken = from + wide + 6;
      texts.push(drawing('text', { class: 'cue-name', x: from, y: room.top + 8 }, text));
    }
  }
  // No line crosses a name.
  return [...lines, ...texts];
}

/** When any drone is beyond a limit, as columns of the time. */
export function excessColumns(shown: Recorded, shift_s: number, duration_s: number, columns: number): number[] {
  const excesses = shown.swarm.head.limits_kept?.excesses ?? [];
  const begins = Float64Array.from(excesses, ({ begins_s }) => begins_s);
  const ends = Float64Array.from(excesses, ({ ends_s }) => ends_s);
  return conflictColumns(begins, ends, shift_s, duration_s, columns);
}
