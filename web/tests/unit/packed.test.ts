// Of a crowd that moves only the bees that are drawn are packed for the graphics card.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BufferGeometry } from 'three';
import { Packed } from '../../src/scene/packed';
import type { Placement } from '../../src/scene/placement';

function placementOf(count: number): Placement {
  const along = (axis: number): Float32Array => Float32Array.from({ length: count }, (_, bee) => 10 * bee + axis);
  const none = new Uint32Array(0);
  return { x: along(0), y: along(1), z: along(2), start: [0, 0, 0], step: [1, 1, 1], shown: none, atRisk: none, lines: none };
}

const list = (...bees: number[]): Uint32Array => Uint32Array.from(bees);

function given(packed: Packed, withCodes: boolean): { geometry: BufferGeometry; read: (name: string, count: number) => number[] } {
  const geometry = new BufferGeometry();
  packed.giveTo(geometry, withCodes);
  return { geometry, read: (name, count) => Array.from(geometry.getAttribute(name).array.slice(0, count)) };
}

test('the crowd comes first in its order, then the others, each once', () => {
  const packed = new Packed(1000);
  const codes = Uint16Array.from({ length: 1000 }, (_, bee) => bee);
  packed.pack(placementOf(1000), list(7, 3, 900), [list(3, 500), list(500, 900, 501, 7)], codes);
  const { read } = given(packed, true);
  assert.deepEqual(read('x', 5), [70, 30, 9000, 5000, 5010]);
  assert.deepEqual(read('y', 5), [71, 31, 9001, 5001, 5011]);
  assert.deepEqual(read('z', 5), [72, 32, 9002, 5002, 5012]);
  assert.deepEqual(read('near', 5), [7, 3, 900, 500, 501]);
  assert.deepEqual(Array.from(packed.slotsOf(list(500, 900, 501, 7))), [3, 2, 4, 0]);
});

test('only what is packed is sent, and the next time nothing of before is left', () => {
  const packed = new Packed(100000);
  const count = 300;
  packed.pack(placementOf(100000), Uint32Array.from({ length: count }, (_, i) => 100 * i), [], null);
  const before = given(packed, false).geometry.getAttribute('x');
  assert.deepEqual('updateRanges' in before && before.updateRanges, [{ start: 0, count }]);
  packed.pack(placementOf(100000), list(5), [list(6)], null);
  const { geometry, read } = given(packed, false);
  const after = geometry.getAttribute('x');
  // What has room stays the same buffer.
  assert.equal(after, before);
  assert.deepEqual('updateRanges' in after && after.updateRanges, [{ start: 0, count: 2 }]);
  assert.deepEqual(read('x', 2), [50, 60]);
  assert.equal(packed.slotsOf(list(100))[0], 0xffffffff);
});

test('a geometry without colours by number has none', () => {
  const packed = new Packed(10);
  packed.pack(placementOf(10), list(1), [], new Uint16Array(10));
  const { geometry } = given(packed, true);
  assert.ok(geometry.getAttribute('near'));
  packed.giveTo(geometry, false);
  assert.equal(geometry.getAttribute('near'), undefined);
});
