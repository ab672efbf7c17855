// Time in which it is not known where bees are, and what is said of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Recording, Separation } from '../../src/data/recording';
import { Spans } from '../../src/data/spans';
import { isOpenAt, longestOpen, runsOf, unknownStretches, unknownText } from '../../src/time/unknown';

/** Who is unknown when; at `known_s` all are. */
function recording(spans: [bee: number, begins_s: number, ends_s: number][], known_s: number[] = []): Recording {
  const [bees, begins, ends] = [0, 1, 2].map((i) => spans.map((span) => span[i]));
  return {
    head: { noun: { one: 'drone', several: 'drones' } },
    unknown: new Spans(Uint32Array.from(bees), Float64Array.from(begins), Float64Array.from(ends)),
    fixes: { isThere: (_bee: number, time_s: number) => known_s.includes(time_s) },
    names: { of: (bee: number) => `drone ${bee}` },
  } as unknown as Recording;
}

const plain = (text: string | null): string | null => text && text.replace(/[\u2066-\u2069]/g, '');

test('one or two who are unknown are named, more are counted', () => {
  const swarm = recording([[0, 1, 9], [1, 5, 8], [4, 6, 7]], [1, 9]);
  assert.equal(unknownText(swarm, 0), null);
  assert.equal(plain(unknownText(swarm, 2)), 'unknown where drone 0 is');
  assert.equal(plain(unknownText(swarm, 5.5)), 'unknown where drone 0 and drone 1 are');
  assert.equal(plain(unknownText(swarm, 6.5)), 'unknown where 3 drones are');
  // At the fixes around a gap it is known.
  assert.equal(unknownText(swarm, 1), null);
  assert.equal(unknownText(swarm, 9), null);
});

test('stretches of several bees that overlap are one', () => {
  assert.equal(unknownStretches(recording([])), 0);
  assert.equal(unknownStretches(recording([[0, 1, 9], [0, 20, 21], [1, 5, 12], [2, 30, 31]])), 3);
});

test('the closest two are unknown within a stretch, and known at its ends', () => {
  const separation = { open: { begins_s: Float64Array.of(1, 10), ends_s: Float64Array.of(3, 12) } } as Separation;
  assert.deepEqual([0, 1, 2, 3, 5, 11, 12, 13].filter((time_s) => isOpenAt(separation, time_s)), [2, 11]);
});

test('columns side by side are hatched as one', () => {
  assert.deepEqual(runsOf([0, 1, 2, 0, 0, 1]), [[1, 2], [5, 1]]);
  assert.deepEqual(runsOf([]), []);
});

test('a page opens where a conflict may be hidden longest', () => {
  const open = (begins: number[], ends: number[]): Separation => ({ open: { begins_s: Float64Array.from(begins), ends_s: Float64Array.from(ends) } }) as unknown as Separation;
  assert.equal(longestOpen(open([], [])), null);
  assert.equal(longestOpen(open([2, 10, 40], [3, 20, 45])), 15);
});
