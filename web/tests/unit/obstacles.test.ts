// Edges of obstacles lie on their surfaces, and on all sides of them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxWith, linesOf, obstacleName } from '../../src/data/obstacles';
import type { Box, Triple } from '../../src/data/positions';
import { formatLimited } from '../../src/panels/limits';

const kBox: Box = { least: [-10, -20, 1], most: [30, 40, 9] };

function extent(places: Triple[]): [number, number][] {
  return [0, 1, 2].map((axis) => [Math.min(...places.map((place) => place[axis])), Math.max(...places.map((place) => place[axis]))]);
}

test('a box and a prism have their corners, a line each side and edge', () => {
  const box = linesOf({ kind: 'box', low: [1, 2, 3], high: [4, 6, 8] }, kBox);
  assert.equal(box.length, 24);
  assert.deepEqual(extent(box), [[1, 4], [2, 6], [3, 8]]);
  const prism = linesOf({ kind: 'prism', outline: [[0, 0], [4, 0], [0, 3]], low_m: 2, high_m: 5 }, kBox);
  assert.equal(prism.length, 18);
  assert.deepEqual(extent(prism), [[0, 4], [0, 3], [2, 5]]);
});

test('all of a sphere and a cylinder is as far from the middle as they are wide', () => {
  for (const [x, y, z] of linesOf({ kind: 'sphere', center: [1, 2, 3], radius_m: 5 }, kBox)) {
    assert.ok(Math.abs(Math.hypot(x - 1, y - 2, z - 3) - 5) < 1e-12);
  }
  const cylinder = linesOf({ kind: 'cylinder', center: [1, 2], radius_m: 5, low_m: 0, high_m: 7 }, kBox);
  for (const [x, y] of cylinder) assert.ok(Math.abs(Math.hypot(x - 1, y - 2) - 5) < 1e-12);
  assert.deepEqual(extent(cylinder)[2], [0, 7]);
});

test('what has no end in height ends with the swarm, or where it begins', () => {
  const heights = (ends: object): [number, number] => extent(linesOf({ kind: 'cylinder', center: [0, 0], radius_m: 1, ...ends }, kBox))[2];
  assert.deepEqual(heights({}), [1, 9]);
  assert.deepEqual(heights({ high_m: 4 }), [1, 4]);
  assert.deepEqual(heights({ high_m: -4 }), [-4, -4]);
  assert.deepEqual(heights({ low_m: 20 }), [20, 20]);
  assert.deepEqual(extent(linesOf({ kind: 'ground', height_m: 2 }, kBox)), [[-10, 30], [-20, 40], [2, 2]]);
  assert.equal(obstacleName({ kind: 'ground', height_m: 2 }, 3), 'obstacles[3], the ground');
});

test('what is near the swarm is seen with it, and what is far away makes it no dot', () => {
  assert.deepEqual(boxWith(kBox, [], 5), kBox);
  const near = boxWith(kBox, [{ kind: 'box', low: [-30, 0, -2], high: [0, 50, 12] }], 5);
  assert.deepEqual(near, { least: [-30, -20, -2], most: [30, 50, 12] });
  const far = boxWith(kBox, [{ kind: 'prism', outline: [[-9000, -9000], [9000, -9000], [0, 9000]], low_m: 0, high_m: 9000 }], 5);
  assert.deepEqual(far, { least: [-70, -80, 0], most: [90, 100, 69] });
});

test('a value beyond its limit never reads as the limit', () => {
  assert.equal(formatLimited(2.4000000001, 2.4, 'm'), '2.4000000001\u202fm');
  assert.equal(formatLimited(2.3999999, 2.4, 'm'), '2.400\u202fm');
  assert.equal(formatLimited(2.5, 2.4, 'm'), '2.500\u202fm');
});
