import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Column } from '../../src/data/column';
import { Fixes } from '../../src/data/fixes';
import { sampleAt } from '../../src/data/recording';
import { Spans } from '../../src/data/spans';
import { speedsOf } from '../../src/data/speeds';
import { Pace } from '../../src/scene/pace';
import { speedFor } from '../../src/time/clock';
import { clearestEnd, conflictColumns, plotScale } from '../../src/time/plot_scales';

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
  // One after the other within a column, and the last two at once.
  assert.deepEqual(conflictColumns(Float64Array.of(0, 1, 2, 2), Float64Array.of(0.5, 1.5, 3, 2.5), 0, 10, 2), [2, 0]);
  assert.deepEqual(conflictColumns(Float64Array.of(0, 2, 4), Float64Array.of(1, 3, 8), 0, 10, 1), [1]);
});

test('the plot shows the threshold whatever the distances are', () => {
  for (const distances of [[], [1, 2], [40, 100], [1000, 2000], new Array<number>(100).fill(1e6)]) {
    const { shareOf } = plotScale(distances, 10);
    assert.ok(shareOf(10) > 0.05 && shareOf(10) < 0.8, `${distances.slice(0, 2).join(', ')}: ${shareOf(10)}`);
    for (const metres of distances) assert.ok(shareOf(metres) >= 0 && shareOf(metres) <= 1);
  }
});

test('one that is very far away does not flatten the others, and scales say what they are', () => {
  const usual = Array.from({ length: 100 }, (_, i) => 4 + i / 20);
  const [plain, wide] = [plotScale(usual, 5), plotScale([...usual, 50000], 5)];
  assert.ok(!plain.byPowersOfTen && wide.byPowersOfTen);
  // Between the closest and the threshold there is something to see in both.
  for (const { shareOf } of [plain, wide]) assert.ok(shareOf(9) - shareOf(4) > 0.05);
  assert.ok(wide.ticks.length >= 2 && wide.ticks.every((tick) => Number.isInteger(Math.log10(tick))));
  for (const tick of wide.ticks) assert.ok(wide.shareOf(tick) >= 0 && wide.shareOf(tick) <= 1);
  assert.equal(wide.shareOf(0), 0);
});

test('velocities are those between fixes; none in a gap, nor of a single fix', () => {
  // As above: 10 to 20 m from 1 to 2 s, away until 4 s, 60 to 80 m from 4 to 5 s.
  const fixes = fixesOf([4, 0, 1], [2, 4, 8, 10, 6], [10, 20, 60, 80, 5], [1]);
  const speed = (bee: number, time: number): number | null => {
    const into: [number, number, number] = [0, 0, 0];
    return fixes.velocity(bee, time, into) ? into[0] : null;
  };
  assert.deepEqual([1, 1.5, 2, 4, 4.9, 5].map((time) => speed(0, time)), [10, 10, 10, 20, 20, 20]);
  assert.deepEqual([speed(1, 3), speed(2, 3)], [null, null]);
  assert.deepEqual(speedsOf(fixes), { usual_mps: 20, most_mps: 20 });
});

test('of a crowd as many are drawn as there is time for, and all again where there is', () => {
  const pace = new Pace(200000);
  const frames = (ms: number, count: number): number => {
    for (let i = 0; i < count; ++i) pace.took(ms);
    return pace.every;
  };
  assert.equal(frames(50, 30), 1);
  // A single slow frame is chance.
  assert.equal((pace.took(900), frames(50, 5)), 1);
  assert.ok(frames(400, 3) >= 4);
  assert.equal(frames(400, 300), 20);
  assert.equal(frames(50, 30), 20);
  assert.equal(frames(10, 30), 1);
  // Of few all are drawn, however slowly.
  const few = new Pace(8000);
  for (let i = 0; i < 30; ++i) few.took(900);
  assert.equal(few.every, 1);
});

test('a recording takes about half a minute', () => {
  assert.equal(speedFor(20), 0.5);
  assert.equal(speedFor(30), 1);
  assert.equal(speedFor(3600), 120);
  assert.equal(speedFor(1e9), 3600);
});

test('what is written on a strip stands where it covers least, as far to the right as that allows', () => {
  const marked = (text: string): boolean[] => Array.from(text, (one) => one === 'x');
  assert.equal(clearestEnd(marked('..x...xx'), 3), 6);
  assert.equal(clearestEnd(marked('x.......'), 3), 8);
  assert.equal(clearestEnd(marked('xxxxxxxx'), 3), 8);
  assert.equal(clearestEnd(marked('x.'), 5), 2, 'longer than the strip');
});
