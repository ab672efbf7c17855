// Which two are closest between the moments for which the engine has said it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { closestNow } from '../../src/data/closest_now';
import type { Column } from '../../src/data/column';
import { Fixes } from '../../src/data/fixes';
import type { RecordingHead } from '../../src/data/page';

/** Of each bee where it is along x at 0, 10 and 20 s; its y is that of its number. */
function fixesOf(xs: number[][]): Fixes {
  const time: Column = { raw: Float64Array.from(xs.flatMap(() => [0, 10, 20])), scale: 1, offset: 0 };
  const x = Uint16Array.from(xs.flat());
  const y = Uint16Array.from(xs.flatMap((_, bee) => [bee, bee, bee]));
  return new Fixes(Uint32Array.from(xs.map(() => 3)), time, { x, y, z: new Uint16Array(x.length), start: [0, 0, 0], step: [1, 1, 1] }, new Uint32Array(0));
}

const head = (more: Partial<RecordingHead> = {}): RecordingHead => ({ threshold_m: 5, position_error_m: 1e-6, ...more }) as RecordingHead;

test('the closest two of a moment are those, not the two of the sample before it', () => {
  // At 0 s the first two are 10 m apart in x, and the last two 30; at 10 s it is the other way round.
  const fixes = fixesOf([[0, 0, 10], [10, 30, 50], [100, 40, 60]].map(([a, b, c], bee) => (bee === 0 ? [0, 1, 10] : [a, b, c])));
  const begin = closestNow(fixes, head(), 0);
  assert.deepEqual([begin?.first, begin?.second], [0, 1]);
  const later = closestNow(fixes, head(), 9);
  assert.deepEqual([later?.first, later?.second], [1, 2]);
  // 28 and 46 m along x, 1 m along y.
  assert.ok(later && Math.abs(later.distance_m - Math.hypot(18, 1)) < 1e-4, `${later?.distance_m}`);
});

test('nothing is told that is not known so exactly, or where one may stand on the ground', () => {
  const moving = fixesOf([[0, 5, 10], [10, 30, 50]]);
  assert.ok(closestNow(moving, head(), 5));
  assert.equal(closestNow(moving, head({ position_error_m: 1 }), 5), null);
  assert.equal(closestNow(fixesOf([[0, 0, 10], [10, 30, 50]]), head(), 5), null);
  assert.ok(closestNow(fixesOf([[0, 0, 10], [10, 30, 50]]), head(), 15));
});

test('with a vertical threshold they are those nearest to a conflict', () => {
  const fixes = fixesOf([[0, 5, 10], [10, 30, 50], [100, 40, 52]]);
  const now = closestNow(fixes, head({ vertical_m: 10 }), 5);
  assert.deepEqual([now?.first, now?.second, now?.height_m], [0, 1, 0]);
});
