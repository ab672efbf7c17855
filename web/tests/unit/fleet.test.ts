import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Fixes } from '../../src/data/fixes';
import { Fleet } from '../../src/data/fleet';
import type { Positions } from '../../src/data/positions';

function along(xs: number[]): Positions {
  const zero = new Uint16Array(xs.length);
  return { x: Uint16Array.from(xs), y: zero, z: zero, start: [0, 0, 0], step: [1, 1, 1] };
}

/**
 * Bee 0 is said nothing of. Bee 1 flies along x at 10 m/s: ticks of a second from 0 to 3, and again at 6. Its branches
 * end at 10, 20, 30 and 40 m, and stop 10 m, 2 s later; the last one departs from the second.
 */
function flown(newest: number[], branches: number[], contract = [0, 0, 0, 0, 0]): Fleet {
  const none = new Uint32Array(5);
  return new Fleet(
    'fleet.ndjson',
    new Fixes(
      Uint32Array.of(0, 5),
      { raw: Uint32Array.of(0, 1, 2, 3, 6), scale: 1, offset: 0 },
      along([0, 10, 20, 30, 50]),
      Uint32Array.of(3),
    ),
    {
      tube_m: Float64Array.of(1, 1, 1, 2, 2),
      contract: Uint32Array.from(contract),
      reason: Uint32Array.from(contract),
      certified: none,
      branches: Uint32Array.from(branches),
      newest: Uint32Array.from(newest),
    },
    {
      from: Uint32Array.of(0, 0, 4),
      time_s: Float64Array.of(1, 2, 3, 4),
      places: along([10, 20, 30, 40]),
      stops: along([20, 30, 40, 50]),
      braking_s: Float64Array.of(2, 2, 2, 2),
      back: Uint32Array.of(0, 1, 1, 2),
    },
  );
}

test('the ghost is on the nominal path, and nowhere where nothing is said', () => {
  const fleet = flown([1, 1, 1, 1, 1], [1, 1, 1, 1, 1]);
  assert.deepEqual([0, 0.5, 2.25, 3].map((time) => fleet.ghost(1, time)?.[0]), [0, 5, 22.5, 30]);
  for (const time of [4.5, 8]) {
    assert.equal(fleet.ghost(1, time), null);
    assert.equal(fleet.told(1, time), null);
    assert.equal(fleet.claim(1, time), null);
    assert.equal(fleet.deviation(1, time, [0, 0, 0]), null);
  }
  assert.equal(fleet.ghost(0, 1), null);
  assert.equal(fleet.told(0, 1), null);
});

test('what is said holds until the next tick', () => {
  const fleet = flown([1, 1, 1, 1, 1], [1, 2, 3, 1, 1], [0, 1, 2, 2, 0]);
  assert.deepEqual([0, 0.9, 1, 2.5, 3].map((time) => fleet.told(1, time)?.contract), ['kept', 'kept', 'doubted', 'out', 'out']);
  assert.deepEqual([0, 1, 2.5].map((time) => fleet.told(1, time)?.branches), [1, 2, 3]);
  assert.equal(fleet.told(1, 3)?.tube_m, 2);
  assert.deepEqual(fleet.outcasts, [{ bee: 1, time_s: 2, reason: 'drifts off faster than it may' }]);
  assert.equal(fleet.doubted, 1);
  assert.equal(fleet.known, 1);
});

test('the claim leads along the newest branch to its stop, and along older ones to theirs', () => {
  const xs = (fleet: Fleet, time: number): unknown => {
    const claim = fleet.claim(1, time);
    return claim && [claim.path.map(([x]) => x), claim.sides.map(({ from, stop, begun }) => [from[0], stop[0], begun])];
  };
  // On the third branch, and perhaps still on those before it.
  const fleet = flown([3, 3, 3, 3, 0], [3, 2, 1, 1, 1]);
  assert.deepEqual(xs(fleet, 0), [[0, 10, 20, 30, 40], [[20, 30, false], [10, 20, false]]]);
  assert.deepEqual(xs(fleet, 1), [[10, 20, 30, 40], [[20, 30, false]]]);
  assert.deepEqual(xs(fleet, 2), [[20, 30, 40], []]);
  assert.deepEqual(xs(fleet, 3), [[30, 40], []]);
  // No branch is known.
  assert.equal(fleet.claim(1, 6), null);
  // The fourth one departs from the second: the third was ruled out.
  assert.deepEqual(xs(flown([4, 4, 4, 4, 4], [2, 2, 2, 2, 2]), 0), [[0, 10, 20, 40, 50], [[20, 30, false]]]);
});

test('a branch that was left may have been braked on since', () => {
  // At 3 s the first branch has stood for a moment, and half of the braking of the second one is over.
  const fleet = flown([3, 3, 3, 3, 3], [3, 3, 3, 3, 3]);
  const sides = fleet.claim(1, 3)?.sides.map(({ from, stop, begun }) => [from[0], stop[0], begun]);
  assert.deepEqual(sides, [[27.5, 30, true], [20, 20, true]]);
  // The nearest nominal place counts.
  assert.equal(fleet.deviation(1, 3, [31, 0, 0]), 1);
  assert.equal(fleet.deviation(1, 3, [27.5, 2, 0]), 2);
  assert.equal(fleet.deviation(1, 3, [17, 0, 0]), 3);
  // What lies ahead does not.
  assert.equal(fleet.deviation(1, 0, [10, 0, 0]), 10);
});
