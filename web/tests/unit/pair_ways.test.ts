// The ways between pairs: how far apart two are at any instant, and how fast they close.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PairWays } from '../../src/data/pair_ways';

const kAxes = (...rows: number[][]): [Float64Array, Float64Array, Float64Array] =>
  rows.map((row) => Float64Array.from(row)) as [Float64Array, Float64Array, Float64Array];

function near(found: number | undefined, wanted: number, what: string): void {
  assert.ok(found !== undefined && Math.abs(found - wanted) < 1e-9, `${what} is ${found}, not ${wanted}`);
}

test('two pass each other: in between the distance is that of the straight way, not of the ends', () => {
  // From 30 m before to 30 m behind, 4 m aside and 3 m above, in 6 s.
  const ways = new PairWays(Uint32Array.of(2), Float64Array.of(10, 16), kAxes([-30, 30], [4, 4], [3, 3]), null, null, false);
  const middle = ways.at(0, 13);
  near(middle?.distance_m, 5, 'the distance');
  near(middle?.horizontal_m, 4, 'horizontally');
  near(middle?.height_m, 3, 'in height');
  near(middle?.closing_mps, 0, 'closing');
  const before = ways.at(0, 11);
  near(before?.distance_m, Math.hypot(20, 5), 'the distance');
  near(before?.closing_mps, (10 * 20) / Math.hypot(20, 5), 'closing');
  assert.ok((ways.at(0, 15)?.closing_mps ?? 0) < 0);
  assert.equal(ways.at(0, 9.99), null);
  assert.equal(ways.at(0, 16.01), null);
});

test('on the Earth horizontal is over the ground, and with heights apart the straight line is that of both', () => {
  const straight = kAxes([0, 0], [7, 7], [0, 0]);
  const ground = kAxes([0, 0], [3, 3], [0, 0]);
  for (const apart of [false, true]) {
    const ways = new PairWays(Uint32Array.of(2), Float64Array.of(0, 1), straight, ground, Float64Array.of(-4, -4), apart);
    const now = ways.at(0, 0.5);
    near(now?.horizontal_m, 3, 'horizontally');
    near(now?.height_m, 4, 'in height');
    near(now?.distance_m, apart ? 5 : 7, 'the distance');
  }
});

test('each pair has its own instants, some have none', () => {
  const ways = new PairWays(Uint32Array.of(2, 0, 1), Float64Array.of(0, 1, 7), kAxes([1, 2, 9], [0, 0, 0], [0, 0, 0]), null, null, false);
  assert.deepEqual(ways.span(0), [0, 1]);
  assert.equal(ways.span(1), null);
  assert.deepEqual(ways.span(2), [7, 7]);
  assert.equal(ways.span(3), null);
  near(ways.at(2, 7)?.distance_m, 9, 'the distance');
  assert.deepEqual(ways.instants(0, 2), [0, 0.5, 1]);
});

test('an instant that is rounded beyond the end of a way is its end', () => {
  const ways = new PairWays(Uint32Array.of(2), Float64Array.of(0, 44.8), kAxes([8, 2], [0, 0], [0, 0]), null, null, false);
  assert.equal(ways.at(0, 44800 * 0.001)?.distance_m, 2);
  assert.ok(44800 * 0.001 > 44.8);
  assert.ok(ways.covers(0, 44800 * 0.001));
  assert.equal(ways.at(0, 44.81), null);
});
