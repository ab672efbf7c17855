// Swarms that move: bees on rings that meet now and then.
import type { RecordingHead } from '../../src/data/page';
import { Elements } from './encode';
import { randomFrom } from './random';

export interface RecordingWish {
  bees: number;
  fixes: number;
  seconds: number;
  threshold_m: number;
  seed: number;
  title: string;
  /** How far neighbours keep out of each other's way: 0 not at all. */
  care?: number;
  since1970?: boolean;
  /** How many moments are looked at to find conflicts. */
  looks?: number;
}

interface Flight {
  at: (t: number) => [number, number, number];
}

function flights({ bees, seed, care = 0 }: RecordingWish): Flight[] {
  const random = randomFrom(seed);
  return Array.from({ length: bees }, (_, bee) => {
    const [phase, tilt, speed] = [random() * 6.28, random() * 2 - 1, 0.6 + 0.8 * random()];
    const radius = 40 + 160 * random();
    const height = 60 + 40 * tilt + care * 30 * (bee % 3);
    return {
      at: (t) => {
        const angle = phase + t * speed * 0.05;
        return [
          radius * Math.cos(angle) + 12 * Math.sin(0.31 * t + bee),
          radius * Math.sin(angle) * 0.8 + 12 * Math.cos(0.23 * t + 2 * bee),
          height + 18 * Math.sin(0.11 * t + 3 * bee),
        ];
      },
    };
  });
}

interface Conflict {
  first: number;
  second: number;
  begins_s: number;
  closest_s: number;
  ends_s: number;
  distance_m: number;
}

function look(all: Flight[], wish: RecordingWish): { conflicts: Conflict[]; separation: [number, number, number, number][] } {
  const open = new Map<string, Conflict>();
  const conflicts: Conflict[] = [];
  const separation: [number, number, number, number][] = [];
  const looks = wish.looks ?? 400;
  for (let step = 0; step <= looks; ++step) {
    const t = (wish.seconds * step) / looks;
    const places = all.map((flight) => flight.at(t));
    let least: [number, number, number, number] = [t, Infinity, 0, 0];
    const now = new Set<string>();
    for (let i = 0; i < places.length; ++i) {
      for (let j = i + 1; j < places.length; ++j) {
        const [dx, dy, dz] = [places[i][0] - places[j][0], places[i][1] - places[j][1], places[i][2] - places[j][2]];
        const d = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (d < least[1]) least = [t, d, i, j];
        if (d >= wish.threshold_m) continue;
        const key = `${i} ${j}`;
        now.add(key);
        const conflict = open.get(key) ?? { first: i, second: j, begins_s: t, closest_s: t, ends_s: t, distance_m: d };
        conflict.ends_s = t;
        if (d < conflict.distance_m) [conflict.distance_m, conflict.closest_s] = [d, t];
        open.set(key, conflict);
      }
    }
    for (const [key, conflict] of open) {
      if (now.has(key) && step < looks) continue;
      conflicts.push(conflict);
      open.delete(key);
    }
    separation.push(least);
  }
  return { conflicts: conflicts.sort((a, b) => a.distance_m - b.distance_m), separation };
}

function spansOf(conflicts: Conflict[]): { bee: number; begins_s: number; ends_s: number }[] {
  const raw = conflicts
    .flatMap(({ first, second, begins_s, ends_s }) => [first, second].map((bee) => ({ bee, begins_s, ends_s })))
    .sort((a, b) => a.bee - b.bee || a.begins_s - b.begins_s);
  const merged: typeof raw = [];
  for (const span of raw) {
    const last = merged[merged.length - 1];
    if (last && last.bee === span.bee && span.begins_s <= last.ends_s) last.ends_s = Math.max(last.ends_s, span.ends_s);
    else merged.push({ ...span });
  }
  return merged;
}

export function recordingHead(elements: Elements, wish: RecordingWish): RecordingHead {
  const all = flights(wish);
  const { conflicts, separation } = look(all.slice(0, 300), wish);
  const spans = spansOf(conflicts);
  const total = wish.bees * wish.fixes;
  const axes = [new Float64Array(total), new Float64Array(total), new Float64Array(total)];
  const times = new Uint32Array(total);
  let fix = 0;
  for (const flight of all) {
    for (let i = 0; i < wish.fixes; ++i, ++fix) {
      const t = (wish.seconds * i) / (wish.fixes - 1);
      times[fix] = Math.round(t * 1000);
      flight.at(t).forEach((metres, axis) => (axes[axis][fix] = metres));
    }
  }
  // Bee 0 is away for a while in the middle.
  const gap = Math.floor(wish.fixes / 2);
  const begins_s = wish.since1970 ? 1764662400 : 0;
  const numbers = (pick: (conflict: Conflict) => number): number[] => conflicts.map(pick);
  const [closest] = conflicts;
  return {
    kind: 'recording',
    title: wish.title,
    source: `${wish.title}, text, comma-separated`,
    count: wish.bees,
    axes: ['x', 'y', 'z'],
    threshold_m: wish.threshold_m,
    inclusive: false,
    position_error_m: 0.004,
    notes: [],
    risk: {
      conflicts: conflicts.length,
      possible: 0,
      pairs: new Set(conflicts.map(({ first, second }) => `${first} ${second}`)).size,
      bees: new Set(spans.map(({ bee }) => bee)).size,
      bee_seconds: spans.reduce((sum, span) => sum + span.ends_s - span.begins_s, 0),
      ...(closest && { closest: { ...closest, time_s: closest.closest_s } }),
    },
    time: { begins_s, ends_s: begins_s + wish.seconds, since_1970: wish.since1970 ?? false },
    fixes: {
      counts: elements.numbers('u32', new Uint32Array(wish.bees).fill(wish.fixes)),
      time_s: elements.numbers('u32', times, { code: 'delta2', scale: 0.001 }),
      x: elements.metres(axes[0], 'delta2'),
      y: elements.metres(axes[1], 'delta2'),
      z: elements.metres(axes[2], 'delta2'),
    },
    absent_after: elements.numbers('u32', [gap]),
    conflicts: {
      first: elements.numbers('u32', numbers((c) => c.first)),
      second: elements.numbers('u32', numbers((c) => c.second)),
      begins_s: elements.numbers('f64', numbers((c) => c.begins_s)),
      closest_s: elements.numbers('f64', numbers((c) => c.closest_s)),
      ends_s: elements.numbers('f64', numbers((c) => c.ends_s)),
      distance_m: elements.numbers('f64', numbers((c) => c.distance_m)),
      certain: elements.numbers('u8', numbers(() => 1)),
    },
    at_risk: {
      bee: elements.numbers('u32', spans.map(({ bee }) => bee), { code: 'delta' }),
      begins_s: elements.numbers('f64', spans.map((span) => span.begins_s)),
      ends_s: elements.numbers('f64', spans.map((span) => span.ends_s)),
    },
    separation: {
      time_s: elements.numbers('f64', separation.map(([t]) => t)),
      distance_m: elements.numbers('f64', separation.map(([, d]) => d)),
      first: elements.numbers('u32', separation.map(([, , first]) => first)),
      second: elements.numbers('u32', separation.map(([, , , second]) => second)),
    },
  };
}
