// Moments below charts are round ones, as clocks and calendars have them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kSeconds } from '../../src/text/calendar';
import { clockStep, momentsWithin, shortStep } from '../../src/time/moments';

const texts = (begins_s: number, ends_s: number, wanted: number): string[] => momentsWithin(begins_s, ends_s, { begins_s, since_1970: true }, wanted).map(({ text }) => text);
const kNoon_s = Date.UTC(2026, 2, 1, 12) / 1000;

test('steps are those of a clock, then whole days', () => {
  assert.deepEqual([0.2, 3, 11, 31, 400, 4000, 50000].map(clockStep), [1, 5, 15, 60, 600, 7200, 86400]);
  assert.deepEqual([90000, 300000, 1e7].map((atLeast_s) => clockStep(atLeast_s) / 86400), [2, 5, 200]);
  for (let atLeast_s = 0.5; atLeast_s < 1e9; atLeast_s *= 1.37) assert.ok(clockStep(atLeast_s) >= atLeast_s);
});

test('each next step of a short time is larger', () => {
  assert.deepEqual([0.0003, 0.02, 0.03, 0.404, 0.6, 1.01, 2.02].map(shortStep), [0.0005, 0.02, 0.05, 0.5, 1, 2, 5]);
  for (let step_s = 1e-9; step_s < 1e9; ) {
    const next_s = shortStep(1.01 * step_s);
    assert.ok(next_s > step_s, `${step_s} s → ${next_s} s`);
    step_s = next_s;
  }
});

test('ten minutes are told by the minute, a minute by seconds, weeks by days', () => {
  assert.deepEqual(texts(kNoon_s + 3, kNoon_s + 600, 5), ['12:02', '12:04', '12:06', '12:08', '12:10']);
  assert.deepEqual(texts(kNoon_s, kNoon_s + 60, 4), ['12:00:00', '12:00:15', '12:00:30', '12:00:45', '12:01:00']);
  assert.deepEqual(texts(kNoon_s, kNoon_s + 3.5 * 86400, 4), ['2026-03-02', '2026-03-03', '2026-03-04', '2026-03-05']);
});

test('a recording with a zero of its own counts seconds', () => {
  assert.deepEqual(momentsWithin(0, 10, kSeconds, 4).map(({ text }) => text.replace('\u202f', ' ')), ['0 s', '2 s', '4 s', '6 s', '8 s', '10 s']);
});
