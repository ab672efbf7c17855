import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { bytesOfBase64 } from '../../src/data/base64';
import { joinPlanes, undoDifferences } from '../../src/data/column';
import { inflate } from '../../src/data/inflate';
import { inflatePlainly } from '../../src/data/inflate_plainly';
import { differences, splitPlanes } from './encode';
import { randomFrom } from './random';

test('planes come back as the numbers they were', () => {
  const random = randomFrom(1);
  for (const [type, most] of [['u8', 255], ['u16', 65535], ['u32', 4294967295]] as const) {
    const numbers = [0, 1, most, most - 1, ...Array.from({ length: 50 }, () => Math.floor(random() * most))];
    assert.deepEqual(Array.from(joinPlanes(splitPlanes(numbers, type), type, numbers.length)), numbers);
  }
  const reals = [0, -0, 1e-300, -1e300, Math.PI, 0.1, Number.MIN_VALUE];
  assert.deepEqual(Array.from(joinPlanes(splitPlanes(reals, 'f64'), 'f64', reals.length)), reals);
});

test('a plane lies whole behind the other', () => {
  assert.deepEqual(Array.from(splitPlanes([0x0102, 0x0304], 'u16')), [2, 4, 1, 3]);
});

test('too few bytes are an error', () => {
  assert.throws(() => joinPlanes(new Uint8Array(3), 'u16', 2), /2 u16/);
});

test('zigzag: 0, −1, 1, −2 are 0, 1, 2, 3', () => {
  const numbers = Uint32Array.of(0, 1, 2, 3);
  undoDifferences(numbers, 'delta');
  assert.deepEqual(Array.from(numbers), [0, 4294967295, 0, 4294967294]);
});

test('differences wrap around and come back', () => {
  const random = randomFrom(2);
  for (const [type, make, most] of [
    ['u8', Uint8Array, 255],
    ['u16', Uint16Array, 65535],
    ['u32', Uint32Array, 4294967295],
  ] as const) {
    const numbers = [0, most, 0, most, 1, Math.floor(most / 2), Math.floor(most / 2) + 1];
    for (let i = 0; i < 200; ++i) numbers.push(Math.floor(random() * (most + 1)));
    for (const code of ['delta', 'delta2'] as const) {
      const coded = make.from(differences(numbers, type, code));
      undoDifferences(coded, code);
      assert.deepEqual(Array.from(coded), numbers, `${type} ${code}`);
    }
  }
});

test('steady motion is zeros in second differences', () => {
  const steady = Array.from({ length: 10 }, (_, i) => 1000 + 7 * i);
  assert.deepEqual(Array.from(differences(steady, 'u16', 'delta2')).slice(2), new Array(8).fill(0));
});

test('base64', () => {
  assert.deepEqual(Array.from(bytesOfBase64(Buffer.from([0, 255, 128, 7]).toString('base64'))), [0, 255, 128, 7]);
});

test('both ways to inflate give back what was compressed', async () => {
  const random = randomFrom(3);
  const noise = Uint8Array.from({ length: 100000 }, () => random() * 256);
  const text = Buffer.from('who is closer than X to whom? '.repeat(3000));
  for (const plain of [new Uint8Array(0), Uint8Array.of(7), noise, new Uint8Array(text)]) {
    for (const options of [{ level: 0 }, { level: 1 }, { level: 9 }, { strategy: 4 }]) {
      const stream = new Uint8Array(deflateSync(plain, options));
      assert.deepEqual(Buffer.from(inflatePlainly(stream)), Buffer.from(plain));
      assert.deepEqual(Buffer.from(await inflate(stream)), Buffer.from(plain));
    }
  }
});

test('a stream that was cut is an error', () => {
  const stream = new Uint8Array(deflateSync(Buffer.from('abcabcabc'.repeat(100))));
  assert.throws(() => inflatePlainly(stream.subarray(0, 8)), /ends early/);
});
