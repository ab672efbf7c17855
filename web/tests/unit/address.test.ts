// What the reader looks at, in the address of the page and back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readAddress, writeAddress } from '../../src/state/address';

test('an address says again what was written', () => {
  const seen = {
    time_s: 955.031,
    swarm: 1,
    bees: [61, 63],
    camera: [1, -2.5, 3e5, 0, 0, 11000.25, 40],
    atRiskOnly: true,
    group: { swarm: 0, place: 2 },
    trails: true,
    vectors: true,
    colourBy: 'speed' as const,
    lift: 20,
  };
  const text = writeAddress(seen);
  assert.match(text, /^#[a-z0-9=&,.+-]+$/);
  assert.deepEqual(readAddress(text), seen);
});

test('nothing to say is no address', () => {
  assert.equal(writeAddress({}), '');
  const plain = readAddress('');
  assert.deepEqual([plain.time_s, plain.bees, plain.camera, plain.lift], [null, [], null, null]);
});

test('what cannot be read is left out, and does no harm', () => {
  for (const text of ['#t=&bees=1,2,3&camera=1,2', '#t=NaN&bees=-1&heights=0', '#bees=1.5&camera=a,b,c,d,e,f,g', '#%%%', '#t=1e999&swarm=-3&colour=taste']) {
    const read = readAddress(text);
    assert.deepEqual([read.time_s, read.bees, read.camera, read.lift, read.swarm], [null, [], null, null, 0], text);
  }
  assert.deepEqual(readAddress('#t=5&nonsense').time_s, 5);
});
