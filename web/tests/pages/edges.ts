// Swarms at the edge of what there can be: nobody, one bee, all at one place, a recording of a moment.
import type { RecordingHead, SnapshotHead } from '../../src/data/page';
import type { Elements } from './encode';

export function fewBees(elements: Elements, count: number, threshold_m: number): SnapshotHead {
  const places = new Array<number>(count).fill(3);
  const pairs = count > 1 && threshold_m > 0 ? 1 : 0;
  return {
    kind: 'snapshot',
    title: `${count} bees`,
    source: 'a test',
    count,
    axes: ['x', 'y', 'z'],
    threshold_m,
    inclusive: true,
    position_error_m: 0,
    notes: [],
    risk: {
      at_risk: 2 * pairs,
      pairs: count > 2 ? null : pairs,
      groups: count > 2 ? null : pairs,
      largest_group: count > 2 ? null : 2 * pairs,
      ...(pairs && { closest: { first: 0, second: 1, distance_m: 0 } }),
    },
    positions: { x: elements.metres(places), y: elements.metres(places), z: elements.metres(places) },
    at_risk: elements.numbers('u8', count > 0 ? [pairs ? 3 : 0] : []),
    ...(count > 1 && { nearest: { code: elements.numbers('u16', new Uint16Array(count)), least_m: 1, ratio: 1.0001 } }),
    pairs: {
      first: elements.numbers('u32', pairs ? [0] : []),
      second: elements.numbers('u32', pairs ? [1] : []),
      distance_m: elements.numbers('f64', pairs ? [0] : []),
    },
  };
}

export function oneMoment(elements: Elements): RecordingHead {
  const none = { u32: elements.numbers('u32', []), f64: elements.numbers('f64', []) };
  return {
    kind: 'recording',
    title: 'a moment',
    source: 'a test',
    count: 2,
    axes: ['x', 'y', 'z'],
    threshold_m: 5,
    inclusive: false,
    position_error_m: 0.001,
    notes: [],
    risk: { conflicts: 0, possible: 0, pairs: 0, bees: 0, bee_seconds: 0 },
    time: { begins_s: 10, ends_s: 10, since_1970: false },
    fixes: {
      counts: elements.numbers('u32', [1, 0]),
      time_s: elements.numbers('f64', [0]),
      x: elements.metres([1]),
      y: elements.metres([1]),
      z: elements.metres([1]),
    },
    absent_after: none.u32,
    conflicts: {
      first: none.u32,
      second: none.u32,
      begins_s: none.f64,
      closest_s: none.f64,
      ends_s: none.f64,
      distance_m: none.f64,
      certain: elements.numbers('u8', []),
    },
    at_risk: { bee: none.u32, begins_s: none.f64, ends_s: none.f64 },
    separation: { time_s: none.f64, distance_m: none.f64, first: none.u32, second: none.u32 },
  };
}
