// Times are told in UTC, in the zone that was named, or as they stand in the file: then never as UTC.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { RecordingTime } from '../../src/data/page';
import { clockTime, formatMoment, formatTime, isoTime, joined, kSeconds, zoneWord, type Calendar } from '../../src/text/calendar';
import type { Swarm } from '../../src/data/swarm';
import { linkTimes } from '../../src/time/linked_times';
import { momentsWithin } from '../../src/time/moments';

const kUtc: Calendar = { begins_s: 0, since_1970: true };
// Clocks in Berlin are set back at 01:00 UTC, from +02:00 to +01:00.
const kTurned_s = Date.UTC(2024, 9, 27, 1) / 1000;
const kBerlin: RecordingTime = {
  begins_s: kTurned_s - 7200,
  ends_s: kTurned_s + 7200,
  since_1970: true,
  clock: { dated: true, zone: 'Europe/Berlin', offsets: [{ from_s: 0, ahead_s: 7200 }, { from_s: 7200, ahead_s: 3600 }] },
};
const kMidnight_s = Date.UTC(2024, 4, 1) / 1000;
const unnamed = (begins_s: number, lasts_s: number, dated = true): RecordingTime => ({
  begins_s,
  ends_s: begins_s + lasts_s,
  since_1970: false,
  clock: { dated, offsets: [{ from_s: 0, ahead_s: dated ? kMidnight_s : 0 }] },
});
const plain = (text: string): string => text.replaceAll('\u202f', ' ');

test('seconds, and times in UTC', () => {
  assert.equal(plain(formatTime(81.25, kSeconds, 1)), '81.3 s');
  assert.equal(formatTime(1764662400.25, kUtc, 2), '2025-12-02 08:00:00.25 UTC');
  assert.equal(formatTime(1764662400, kUtc, 0), '2025-12-02 08:00:00 UTC');
  assert.equal(isoTime(1764662400.25, kUtc), '2025-12-02T08:00:00.250Z');
  assert.equal(isoTime(81.25, kSeconds), '');
  assert.deepEqual([kUtc, kSeconds].map(zoneWord), ['UTC', 'time']);
});

test('of a zone the local time with its offset, which changes where clocks are turned', () => {
  assert.equal(formatTime(kTurned_s - 1, kBerlin, 0), '2024-10-27 02:59:59 +02:00');
  assert.equal(formatTime(kTurned_s, kBerlin, 0), '2024-10-27 02:00:00 +01:00');
  assert.equal(formatMoment(0, kBerlin), '2024-10-27 01:00:00.0 +02:00');
  assert.equal(isoTime(kTurned_s, kBerlin), '2024-10-27T02:00:00.000+01:00');
  // Just before the beginning, as rounding may put it, and behind the end.
  assert.equal(clockTime(kBerlin.begins_s - 0.001, kBerlin, 0)?.zone, '+02:00');
  assert.equal(clockTime(kBerlin.ends_s + 1, kBerlin, 0)?.zone, '+01:00');
  assert.equal(zoneWord(kBerlin), 'local');
  assert.equal(zoneWord({ begins_s: 0, since_1970: true, clock: { dated: true, zone: 'x', offsets: [{ from_s: 0, ahead_s: -12600 }] } }), '-03:30');
  const texts = momentsWithin(kBerlin.begins_s, kBerlin.ends_s, kBerlin, 4).map(({ text }) => text);
  assert.deepEqual(texts, ['01:00', '02:00', '02:00', '03:00', '04:00']);
});

test('whole days are those of the clock, before and behind its turn', () => {
  const days = { ...kBerlin, begins_s: kTurned_s - 2 * 86400, ends_s: kTurned_s + 2 * 86400, clock: { dated: true, zone: 'Europe/Berlin', offsets: [{ from_s: 0, ahead_s: 7200 }, { from_s: 172800, ahead_s: 3600 }] } };
  const moments = momentsWithin(days.begins_s, days.ends_s, days, 4);
  assert.deepEqual(moments.map(({ text }) => text), ['2024-10-26', '2024-10-27', '2024-10-28', '2024-10-29']);
  assert.deepEqual(moments.map(({ time_s }) => clockTime(time_s, days, 0)?.time), ['00:00:00', '00:00:00', '00:00:00', '00:00:00']);
});

test('what names no zone is told as it stands in the file', () => {
  const recorded = unnamed(9 * 3600, 60);
  assert.equal(formatTime(9 * 3600 + 25.5, recorded, 1), '2024-05-01 09:00:25.5');
  assert.equal(isoTime(9 * 3600, recorded), '2024-05-01 09:00:00.000');
  assert.equal(zoneWord(recorded), 'time');
  const undated = unnamed(9 * 3600, 60, false);
  assert.equal(formatTime(9 * 3600, undated, 0), '09:00:00');
  assert.equal(isoTime(9 * 3600, undated), '09:00:00.000');
  for (const { text } of momentsWithin(9 * 3600, 9 * 3600 + 60, recorded, 4)) assert.match(text, /^09:0[01]:\d\d$/);
});

test('two recordings with one zone are told together', () => {
  const later = { ...kBerlin, begins_s: kTurned_s + 10, clock: { dated: true, zone: 'Europe/Berlin', offsets: [{ from_s: 0, ahead_s: 3600 }] } };
  for (const both of [joined(kBerlin, later), joined(later, kBerlin)]) {
    assert.equal(formatTime(kTurned_s - 1, both, 0), '2024-10-27 02:59:59 +02:00');
    assert.equal(formatTime(kTurned_s + 11, both, 0), '2024-10-27 02:00:11 +01:00');
    assert.equal(both.clock?.offsets.length, 2);
  }
});

test('clocks without a zone that count from other midnights are laid beside each other by what they show', () => {
  const swarm = (time: RecordingTime): Swarm => ({ kind: 'recording', head: { time }, fixes: { bees: 1, countOf: () => 2 } }) as unknown as Swarm;
  // The second one counts from the midnight before.
  const clock = { dated: true, offsets: [{ from_s: 0, ahead_s: kMidnight_s - 86400 }] };
  const other: RecordingTime = { ...unnamed(33 * 3600 + 30, 60), clock };
  const swarms = [swarm(unnamed(9 * 3600, 60)), swarm(other)];
  const times = linkTimes(swarms);
  assert.equal(times.note, null);
  assert.equal(times.clockTime({ swarm: swarms[1] }, 0), 30);
  assert.equal(formatTime(times.zero_s + 30, times.calendar, 0), '2024-05-01 09:00:30');
  // At the same time of another day.
  assert.notEqual(linkTimes([swarms[0], swarm({ ...unnamed(9 * 3600, 60), clock })]).note, null);
});
