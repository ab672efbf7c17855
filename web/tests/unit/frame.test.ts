// Where things are drawn: y of pictures downwards, balls as balls; and in what lengths are told.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Head } from '../../src/data/page';
import { Frame, liftFor } from '../../src/scene/frame';
import { lengthUnits } from '../../src/text/apart';

const plain = (text: string): string => text.replaceAll('\u202f', ' ');

test('y of a picture is drawn downwards, and found again', () => {
  const frame = new Frame({ least: [0, 0, 0], most: [640, 480, 0] }, 1);
  assert.ok(frame.toScene([0, 400, 0])[1] > frame.toScene([0, 100, 0])[1]);
  frame.up = -1;
  assert.deepEqual(frame.toScene([320, 0, 0]), [0, 240, 0]);
  assert.deepEqual(frame.toScene([320, 480, 0]), [0, -240, 0]);
  assert.deepEqual(frame.fromScene(frame.toScene([12, 34, 0])), [12, 34, 0]);
});

test('heights of a wide area are lifted beside a limit in height, but no ball becomes an egg', () => {
  const wide = { least: [0, 0, 0], most: [100000, 100000, 1000] } as const;
  const box = { least: [...wide.least], most: [...wide.most] } as ConstructorParameters<typeof Frame>[0];
  assert.equal(liftFor(box, 9260, 304.8), 10);
  assert.equal(liftFor(box, 50, undefined), 1);
});

test('of aviation lengths along the ground are in nautical miles, and heights in feet', () => {
  const units = (head: object): string[] => {
    const { ground, height } = lengthUnits(head as Head);
    return [10 * 1852, 1852].map((metres) => plain(ground(metres).text(metres / ground(metres).metres))).concat(plain(height.text(1)));
  };
  assert.deepEqual(units({ aviation: true, threshold_m: 9260 }), ['10 NM', '1 NM', '1 ft']);
  assert.deepEqual(units({ aviation: true, threshold_m: 30 }), ['10 NM', '6,076 ft', '1 ft']);
  assert.deepEqual(units({ threshold_m: 9260 }), ['18,520 m', '1,852 m', '1 m']);
  assert.deepEqual(units({ threshold_m: 9260, heights: { in_feet: true, by_pressure: true } })[2], '1 ft');
});
