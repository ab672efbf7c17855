import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Column } from '../../src/data/column';
import { Fixes } from '../../src/data/fixes';
import { sampleAt } from '../../src/data/recording';
import { Spans } from '../../src/data/spans';
import { speedFor } from '../../src/time/clock';
import { conflictColumns, plotTop } from '../../src/time/plot_scales';

function fixesOf(counts: number[], times: number[], xs: number[], gaps: number[]): Fixes {
  const time: Column = { raw: Uint32Array.from(times), scale: 0.5, offset: 0 };
  const x = Uint16Array.from(xs);
  const zero = new Uint16Array(xs.length);
  return new Fixes(Uint32Array.from(counts), time, { x, y: zero, z: zero, start: [0, 0, 0], step: [1, 1, 1] }, Uint32Array.from(gaps));
}

function xAt(fixes: Fixes, bee: number, time: number): number | null {
  const [x, y, z] = [new Float32Array(1), new Float32Array(1), new Float32Array(1)];
  return fixes.place(bee, time, x, y, z, 0) ? x[0] : null;
}

test('a bee is on the straight line between two fixes, and nowhere more than a step before, after and in a gap', () => {
  // Times in half seconds: bee 0 at 1, 2, 4 and 5 s, away from 2 to 4; bee 1 without fixes; bee 2 once.
  const fixes = fixesOf([4, 0, 1], [2, 4, 8, 10, 6], [10, 20, 60, 80, 5], [1]);
  const expected: [number, number, number | null][] = [
    [0, 0.4, null], [0, 0.6, 10], [0, 1, 10], [0, 1.25, 12.5], [0, 2, 20], [0, 2.4, 20], [0, 2.6, null], [0, 3.4, null],
    [0, 3.6, 60],
    [0, 4, 60], [0, 4.5, 70], [0, 5, 80], [0, 5.4, 80], [0, 5.6, null], [1, 3, null], [2, 2.4, null], [2, 3, 5],
    [2, 3.6, null],
  ];
  for (const [bee, time, x] of expected) assert.equal(xAt(fixes, bee, time), x, `bee ${bee} at ${time}`);
  // The same backwards: where one was before does not matter.
  for (const [bee, time, x] of expected.reverse()) assert.equal(xAt(fixes, bee, time), x, `bee ${bee} at ${time}`);
});

test('leaps in time end where steps do', () => {
  const count = 1000;
  const times = Array.from({ length: count }, (_, i) => 2 * i);
  const fixes = fixesOf([count], times, times.map((time) => time * 10), []);
  for (const time of [0, 999, 3.5, 998.5, 500, 501, 2, 700.25]) assert.equal(xAt(fixes, 0, time), time * 20);
});

test('a bee is in conflict while a span of it covers the time', () => {
  const spans = new Spans(Uint32Array.of(2, 2, 9), Float64Array.of(1, 5, 0), Float64Array.of(3, 6, 2));
  assert.deepEqual([0, 1, 3, 4, 5.5, 7].map((time) => spans.beesAt(time)), [[9], [2, 9], [2], [], [2], []]);
  assert.equal(spans.secondsOf(2), 3);
  assert.equal(spans.secondsOf(3), 0);
});

test('the sample of a moment is the one before it', () => {
  const times = Float64Array.of(1, 2, 4);
  assert.deepEqual([0, 1, 1.5, 2, 3.9, 9].map((time) => sampleAt(times, time)), [0, 0, 0, 1, 1, 2]);
  assert.equal(sampleAt(new Float64Array(0), 1), -1);
});

test('columns of the time line count the bees in conflict', () => {
  assert.deepEqual(conflictColumns(Float64Array.of(0, 5), Float64Array.of(5.5, 10), 0, 10, 5), [1, 1, 2, 1, 1]);
  assert.deepEqual(conflictColumns(Float64Array.of(0), Float64Array.of(1), 8, 10, 5), [0, 0, 0, 0, 1]);
});

test('the plot shows the threshold whatever the distances are', () => {
  for (const distances of [[], [1, 2], [1000, 2000]]) assert.ok(plotTop(distances, 10) > 12);
  assert.equal(plotTop(new Array(100).fill(1e6), 10), 120);
});

test('a recording takes about half a minute', () => {
  assert.equal(speedFor(20), 0.5);
  assert.equal(speedFor(30), 1);
  assert.equal(speedFor(3600), 120);
  assert.equal(speedFor(1e9), 3600);
});
