// How a bee flew: speeds between fixes, over stretches that are long enough for the rounding of positions, and gaps.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Fixes } from '../../src/data/fixes';
import { flownBy, stretchAt } from '../../src/data/flown';
import type { Recording } from '../../src/data/recording';

/** One bee; positions in steps of `step` metres. */
function recordingOf(times: number[], x: number[], z: number[], step: number, absentAfter: number[] = []): Recording {
  const positions = {
    x: Uint16Array.from(x, (metres) => Math.round(metres / step)),
    y: new Uint16Array(x.length),
    z: Uint16Array.from(z, (metres) => Math.round(metres / step)),
    start: [0, 0, 0] as [number, number, number],
    step: [step, step, step] as [number, number, number],
  };
  const fixes = new Fixes(Uint32Array.of(times.length), { raw: Float64Array.from(times), scale: 1, offset: 0 }, positions, Uint32Array.from(absentAfter));
  return { kind: 'recording', fixes } as unknown as Recording;
}

test('speeds are those between two fixes, along the ground and up', () => {
  const flown = flownBy(recordingOf([0, 2, 3, 5], [0, 10, 20, 20], [8, 4, 4, 5], 1e-3), 0);
  assert.deepEqual(Array.from(flown.horizontal_mps, Math.round), [5, 10, 0]);
  assert.deepEqual(Array.from(flown.climb_mps), [-2, 0, 0.5]);
  assert.deepEqual([-1, 0, 1, 2.5, 4, 5, 6].map((time_s) => stretchAt(flown, time_s)), [-1, 0, 0, 1, 2, 2, -1]);
});

test('none leads across a gap', () => {
  const flown = flownBy(recordingOf([0, 1, 2, 10, 11], [0, 1, 2, 100, 102], [0, 0, 0, 0, 0], 1e-3, [2]), 0);
  assert.deepEqual(Array.from(flown.from_s), [0, 1, 10]);
  assert.deepEqual(Array.from(flown.to_s), [1, 2, 11]);
  assert.equal(stretchAt(flown, 5), -1);
});

test('where positions are rounded much, stretches are so long that speeds are not', () => {
  // 10 m/s in steps of 3 m, ten times a second: between two fixes anything from 0 to 30 m/s.
  const times = Array.from({ length: 1001 }, (_, i) => i / 10);
  const flown = flownBy(recordingOf(times, times.map((time_s) => 10 * time_s), times.map(() => 0), 3), 0);
  assert.ok(flown.over_s > 1, `${flown.over_s} s`);
  assert.ok(flown.horizontal_mps.every((speed) => Math.abs(speed - 10) < 0.5));
  assert.equal(stretchAt(flown, 50) >= 0, true);
});
