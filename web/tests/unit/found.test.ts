import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findGroups } from '../../src/data/groups';
import { Nearest, quantileCode } from '../../src/data/nearest';
import { Neighbours } from '../../src/data/neighbours';
import { listBits } from '../../src/data/snapshot';
import { Names } from '../../src/data/names';
import { alignedRange, binDistances, distanceTicks } from '../../src/panels/histogram';
import { sortedPlaces } from '../../src/panels/paged_table';
import { randomFrom } from './random';

test('groups hang together by pairs, the largest first', () => {
  const { list, of } = findGroups(9, Uint32Array.of(4, 1, 7, 2), Uint32Array.of(5, 2, 8, 6), Float64Array.of(3, 2, 1, 4));
  assert.deepEqual(list, [
    { number: 0, bees: [1, 2, 6], closest_m: 2 },
    { number: 2, bees: [7, 8], closest_m: 1 },
    { number: 1, bees: [4, 5], closest_m: 3 },
  ]);
  assert.deepEqual(Array.from(of), [-1, 0, 0, -1, 2, 2, 0, 1, 1]);
});

test('groups are those of a plain search', () => {
  const random = randomFrom(5);
  const count = 60;
  const first = Uint32Array.from({ length: 40 }, () => random() * count);
  const second = Uint32Array.from(first, (bee) => (bee + 1 + Math.floor(random() * (count - 1))) % count);
  const { list } = findGroups(count, first, second, new Float64Array(40).fill(1));
  const reach = (from: number): number[] => {
    const seen = new Set([from]);
    for (const bee of seen) {
      first.forEach((a, i) => {
        if (a === bee) seen.add(second[i]);
        if (second[i] === bee) seen.add(a);
      });
    }
    return [...seen].sort((a, b) => a - b);
  };
  for (const group of list) assert.deepEqual(group.bees, reach(group.bees[0]));
  assert.equal(list.reduce((sum, group) => sum + group.bees.length, 0), new Set([...first, ...second]).size);
});

test('neighbours: in which pairs a bee is, the closest first', () => {
  const neighbours = new Neighbours(5, Uint32Array.of(0, 1, 0), Uint32Array.of(1, 3, 3));
  assert.deepEqual([0, 1, 2, 3, 4].map((bee) => Array.from(neighbours.placesOf(bee))), [[0, 2], [0, 1], [], [1, 2], []]);
});

test('bits: bit b of number k is bee 8k + b', () => {
  assert.deepEqual(Array.from(listBits([0b10000001, 0b00000010], 16)), [0, 7, 9]);
  assert.deepEqual(Array.from(listBits([0xff], 3)), [0, 1, 2]);
});

test('nearest distances and their codes', () => {
  const nearest = new Nearest(Uint16Array.of(0, 1, 2, 101), 0.5, 1.01);
  assert.equal(nearest.distance(0), 0);
  assert.equal(nearest.distance(1), 0.5);
  assert.ok(Math.abs(nearest.distance(3) - 0.5 * 1.01 ** 100) < 1e-12);
  assert.ok(Math.abs(nearest.toCode(nearest.distance(3)) - 101) < 1e-9);
  assert.equal(nearest.toCode(0), 0);
  assert.equal(quantileCode(nearest.countCodes(), 0.5), 1);
  assert.equal(quantileCode(nearest.countCodes(), 1), 101);
});

test('a histogram counts each bee once', () => {
  // At 0, 1, 8, 16 and 2^99 m.
  const nearest = new Nearest(Uint16Array.of(0, 1, 4, 5, 100), 1, 2);
  const { counts, atRisk } = binDistances(nearest, (bee) => bee === 1, [1, 100], 2);
  assert.deepEqual(counts, [3, 2]);
  assert.deepEqual(atRisk, [1, 0]);
});

test('bars stand on the side of the threshold where their distances are', () => {
  for (const [distance_m, threshold_m] of [[37.7, 100], [114, 100], [5, 5.01], [5, 4.99], [0.001, 100]]) {
    for (const ratio of [1, 1.0001, 1.2]) {
      const range_m = alignedRange([Math.min(distance_m, threshold_m) / 1.1, Math.max(distance_m, threshold_m) * 1.1], threshold_m, 60);
      const { counts } = binDistances(new Nearest(Uint16Array.of(1), distance_m, ratio), () => false, range_m, 60);
      const bin = counts.indexOf(1);
      const edge_m = (place: number): number => range_m[0] * (range_m[1] / range_m[0]) ** (place / 60);
      const [low_m, high_m] = [edge_m(bin), edge_m(bin + 1)];
      assert.ok(low_m <= distance_m * 1.000001 && distance_m <= high_m * 1.000001, `${distance_m} m in ${low_m} to ${high_m} m`);
      assert.ok(distance_m < threshold_m ? high_m <= threshold_m * 1.000001 : low_m >= threshold_m * 0.999999);
    }
  }
});

test('ticks of distances lie within, and are few', () => {
  assert.deepEqual(distanceTicks(0.7, 12), [1, 3, 10]);
  assert.ok(distanceTicks(1e-6, 1e6).length <= 7);
});

test('sorting keeps the order of equals', () => {
  const ranks = [2, 1, 2, 0];
  assert.deepEqual(Array.from(sortedPlaces(4, (i) => ranks[i], false)), [3, 1, 0, 2]);
  assert.deepEqual(Array.from(sortedPlaces(4, (i) => ranks[i], true)), [0, 2, 1, 3]);
});

test('names: of a moment, where a bee has several one after the other', () => {
  const called = { bees: Uint32Array.of(1, 1), since_s: Float64Array.of(10, 50), texts: ['a1 (UAL1)', 'a1 (UAL2)'] };
  const names = new Names(['b', 'a1 (UAL1, UAL2)'], null, called);
  assert.deepEqual([0, 10, 49, 50, 99].map((time_s) => names.at(time_s, 1)), ['a1 (UAL1)', 'a1 (UAL1)', 'a1 (UAL1)', 'a1 (UAL2)', 'a1 (UAL2)']);
  assert.equal(names.at(50, 0), 'b');
  assert.equal(names.of(1), 'a1 (UAL1, UAL2)');
});

test('names: numbers, texts of all, texts of some', () => {
  const numbers = new Names(null, null);
  assert.equal(numbers.of(12), '12');
  assert.deepEqual(numbers.find('12', 130, 20), [12, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129]);
  assert.deepEqual(numbers.find('0', 5, 20), [0]);
  assert.deepEqual(numbers.find('x', 5, 20), []);
  const texts = new Names(['Maya', 'Willi', 'maya2'], null);
  assert.deepEqual(texts.find('maya', 3, 20), [0, 2]);
  assert.equal(texts.bee('Willi', 3), 1);
  assert.equal(texts.bee('willi', 3), null);
  const some = new Names(['Maya'], Uint32Array.of(7));
  assert.equal(some.of(7), 'Maya');
  assert.equal(some.of(3), '3');
  assert.deepEqual(some.find('3', 10, 20), [3]);
  assert.deepEqual(some.find('may', 10, 20), [7]);
});
