import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Head } from '../../src/data/page';
import { axisUnits, formatApart, formatHorizontal, formatVertical, lengthUnit, limitsOf, rankOf } from '../../src/text/apart';
import { niceBelow, niceTicks } from '../../src/text/nice_steps';
import { isolate, shorten } from '../../src/text/names';
import * as numbers from '../../src/text/numbers';
import { tooClose } from '../../src/text/threshold';

const plain = (text: string): string => text.replace(/[\u202f\u00a0]/g, ' ').replaceAll('\u2212', '-');

test('counts have their thousands apart', () => {
  assert.deepEqual([0, 999, 1000, 1234567, -1234].map((n) => plain(numbers.formatCount(n))), ['0', '999', '1,000', '1,234,567', '-1,234']);
});

test('distances keep four digits that matter', () => {
  const shown = [0, 0.0912345, 2.2254, 12.3456, 1234.56, 19999.9, 25000, 123456.7].map((m) => plain(numbers.formatMetres(m)));
  assert.deepEqual(shown, ['0 m', '91.23 mm', '2.225 m', '12.35 m', '1,235 m', '20,000 m', '25.00 km', '123.5 km']);
  assert.equal(numbers.formatMetres(NaN), '–');
  assert.equal(plain(numbers.formatMetres(3e-9)), '< 1 µm');
});

test('what is below a limit reads as below it', () => {
  const shown = [99.2, 99.9996, 99.99999999, 100, 120].map((m) => plain(numbers.formatBelow(m, 100)));
  assert.deepEqual(shown, ['99.20 m', '99.9996 m', 'just under 100 m', '100.0 m', '120.0 m']);
  assert.equal(plain(numbers.formatBelow(24999.7, 25000)), '24.9997 km');
  assert.equal(plain(numbers.formatBelow(1e-9, 5)), '< 1 mm');
  assert.equal(plain(numbers.formatBelow(1e-9, 0.1)), '< 1 µm');
  assert.equal(plain(numbers.formatBelow(5.9994e-6, 1e-5, 3)), '6.00 µm');
  assert.equal(plain(numbers.formatBelow(9.99996e-6, 1e-5, 3)), '9.99996 µm');
  assert.equal(plain(numbers.formatExactly(1e-5)), '10 µm');
  assert.equal(plain(numbers.formatBelow(0.0029999, 0.003)), '2.9999 mm');
});

test('conflicts with two limits are told and ordered by both', () => {
  const head = { threshold_m: 9260, vertical_m: 304.8, aviation: true } as Head;
  // A climb through a level, told where it ends, and two that meet at one height, farther apart.
  const climb = { horizontal_m: 1945, height_m: 304.79999 };
  const level = { horizontal_m: 2580, height_m: 0 };
  assert.equal(plain(formatApart(2580, level, head)), '1.39 NM, 0 ft');
  assert.ok(rankOf(2580, level, head) < rankOf(1968, climb, head));
  assert.equal(plain(formatApart(2580, level, { threshold_m: 9260 } as Head)), '2,580 m');
  assert.equal(rankOf(2580, level, { threshold_m: 9260 } as Head), 2580);
  assert.equal(rankOf(2580, { horizontal_m: NaN, height_m: NaN }, head), Infinity);
});

test('separations are below their limits in every unit', () => {
  const head = { threshold_m: 9260, vertical_m: 304.8, aviation: true } as Head;
  assert.deepEqual([5475.3, 9259.9, 9260, 12000].map((m) => plain(formatHorizontal(m, head))), [
    '2.96 NM · 5,475 m', '4.9999 NM · 9,259.9 m', '5.00 NM · 9,260 m', '6.48 NM · 12,000 m',
  ]);
  assert.deepEqual([91.44, 304.7, 304.8, 0].map((m) => plain(formatVertical(m, head))), [
    '300 ft · 91.44 m', '999.7 ft · 304.7 m', '1,000 ft · 304.8 m', '0 ft · 0 m',
  ]);
  assert.deepEqual([0.001416, 304.79998].map((m) => plain(formatVertical(m, head))), [
    '0 ft · 0 m', 'just under 1,000 ft · just under 304.8 m',
  ]);
  assert.deepEqual(Object.values(limitsOf(head)).map(plain), ['5 NM', '1,000 ft']);
  assert.deepEqual(Object.values(limitsOf({ threshold_m: 9260, vertical_m: 304.8 } as Head)).map(plain), ['9,260 m', '304.8 m']);
});

test('what is a few feet apart is told in feet', () => {
  const head = { threshold_m: 5 * 0.3048, aviation: true } as Head;
  assert.equal(plain(formatHorizontal(0.35052, head)), '1.15 ft · 0.3505 m');
  assert.equal(plain(formatVertical(1.05, head)), '3.44 ft · 1.050 m');
  assert.equal(plain(lengthUnit(head).text(2.5)), '2.5 ft');
  assert.equal(plain(axisUnits(head).horizontal.text(2.5)), '2.5 ft');
  assert.equal(plain(tooClose(head)), 'closer than 5 ft (1.524 m)');
  assert.equal(plain(tooClose({ threshold_m: 1.524 } as Head)), 'closer than 1.524 m');
  const wide = { ...head, threshold_m: 500 * 0.3048, vertical_m: 100 * 0.3048 };
  assert.deepEqual([formatHorizontal(41.76, wide), formatVertical(20, wide)].map(plain), ['137 ft · 41.76 m', '66 ft · 20.00 m']);
  assert.equal(plain(tooClose(wide)), 'closer than 500 ft horizontally and 100 ft in height (152.4 m, 30.48 m)');
});

test('axes of the small are in millimetres', () => {
  const head = { threshold_m: 0.003 } as Head;
  assert.equal(plain(lengthUnit(head).text(12.5)), '12.5 mm');
  assert.equal(axisUnits(head).vertical.metres, 0.001);
  assert.equal(plain(lengthUnit({ threshold_m: 5 } as Head).text(12.5)), '12.5 m');
});

test('settings are written as they were given', () => {
  assert.deepEqual([5, 0.125, 1500, -2.5, 1e21, 0.003, 0.0254, -0.0003].map((m) => plain(numbers.formatExactly(m))), ['5 m', '0.125 m', '1,500 m', '-2.5 m', '1e+21 m', '3 mm', '25.4 mm', '-0.3 mm']);
});

test('errors are never rounded down', () => {
  assert.deepEqual([0, 0.0151, 0.015, 1.21, 4e-7, 0.0999, 1e-15].map((m) => plain(numbers.formatError(m))), ['0 m', '16 mm', '15 mm', '1.3 m', '0.40 µm', '100 mm', '0.01 µm']);
});

test('coordinates end where their error begins', () => {
  assert.equal(plain(numbers.formatCoordinate(-1234.56789, 0.016)), '-1,234.57 m');
  assert.equal(plain(numbers.formatCoordinate(0.001, 3)), '0 m');
});

test('degrees end there too, and can be copied', () => {
  assert.equal(numbers.formatDegrees(-75.123456789012, 0.016), '-75.1234568°');
  assert.equal(numbers.formatDegrees(6.25, 1500), '6.25°');
  assert.equal(numbers.formatDegrees(6.25, 0), '6.25000000°');
});

test('ticks end, however narrow or far away the range is', () => {
  assert.deepEqual(niceTicks(0.3, 0.30000000000000004, 5), []);
  assert.deepEqual(niceTicks(9.999999999999998, 10, 5), []);
  assert.deepEqual(niceTicks(1e300, 1.1e300, 2).length > 0, true);
  assert.deepEqual(niceTicks(1700000000.001, 1700000000.004, 3), [1700000000.001, 1700000000.002, 1700000000.003, 1700000000.004]);
});

test('shares', () => {
  assert.deepEqual([[0, 5], [1, 8], [1, 100000], [99999, 100000], [5, 5], [0, 0]].map(([a, b]) => plain(numbers.formatShare(a, b))), [
    '0.0 %', '12.5 %', '< 0.1 %', '> 99.9 %', '100.0 %', '–',
  ]);
});

test('durations and times', () => {
  assert.deepEqual([0, 3.2, 99.9, 125, 7380].map((s) => plain(numbers.formatDuration(s))), ['0 s', '3.20 s', '99.9 s', '2 min 05 s', '2 h 03 min']);
  assert.deepEqual([10, 1, 0.5, 0.04, 0].map(numbers.decimalsFor), [0, 0, 1, 2, 1]);
});

test('steps that people count in', () => {
  assert.deepEqual([1, 1.9, 2, 4.9, 7, 0.03, 300].map(niceBelow), [1, 1, 2, 2, 5, 0.02, 200]);
  assert.deepEqual(niceTicks(-1.2, 3.1, 4), [-1, 0, 1, 2, 3]);
  assert.deepEqual(niceTicks(1, 1, 4), []);
  for (const [least, most] of [[0, 1], [-3e5, 1e6], [0.001, 0.0042]]) {
    const ticks = niceTicks(least, most, 5);
    assert.ok(ticks.length >= 3 && ticks.length <= 12, `${ticks}`);
  }
});

test('long names are cut between characters', () => {
  assert.equal(shorten('Maya'), 'Maya');
  assert.equal(shorten(''), '(no name)');
  const bees = shorten('\u{1F41D}'.repeat(10000), 5);
  assert.equal(bees, '\u{1F41D}\u{1F41D}…\u{1F41D}\u{1F41D}');
  assert.equal(shorten('x'.repeat(64)), 'x'.repeat(64));
  assert.equal(shorten('x'.repeat(65)).length, 64);
  assert.equal(shorten(`a\u{1F41D}\u{1F41D}\u{1F41D}bc\u{1F41D}`, 4), 'a\u{1F41D}…\u{1F41D}');
});

test('names that differ at their ends still do when they are cut', () => {
  const [one, other] = [1, 2].map((number) => shorten(`robot-${'with-a-very-long-name-'.repeat(5)}${number}`));
  assert.ok(one !== other && one.endsWith('1') && other.endsWith('2') && one.length === 64);
});

test('a name that turns the text around stays between its marks', () => {
  assert.equal(isolate('\u202Eab'), '\u2068\u202Eab\u2069');
});
