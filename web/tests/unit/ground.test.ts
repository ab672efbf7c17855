// Coasts and borders: what is packed is the Earth, and only what is around the swarm is taken of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { bytesOfBase64 } from '../../src/data/base64';
import { clipped, unpackGround } from '../../src/data/ground';
import { inflate } from '../../src/data/inflate';
import { randomFrom } from './random';

test('a piece is cut at the edges of the box', () => {
  const box = [0, 0, 10, 5];
  assert.deepEqual(clipped([1, 1, 9, 4], box), [1, 1, 9, 4]);
  assert.deepEqual(clipped([-10, 2, 20, 2], box), [0, 2, 10, 2]);
  assert.deepEqual(clipped([5, -5, 5, 3], box), [5, 0, 5, 3]);
  assert.deepEqual(clipped([-1, -1, -1, 9], box), []);
  assert.deepEqual(clipped([-2, 4, 1, 9], box), []);
  const random = randomFrom(3);
  for (let i = 0; i < 300; ++i) {
    const [ax, ay, bx, by] = Array.from({ length: 4 }, () => 30 * random() - 10);
    const part = clipped([ax, ay, bx, by], box);
    const within = (x: number, y: number): boolean => x >= -1e-9 && x <= 10 + 1e-9 && y >= -1e-9 && y <= 5 + 1e-9;
    for (let share = 0; share <= 1; share += 1 / 32) {
      const [x, y] = [ax + share * (bx - ax), ay + share * (by - ay)];
      if (!within(x, y)) continue;
      const [fx, fy, tx, ty] = part;
      const length = Math.hypot(tx - fx, ty - fy);
      assert.ok(part.length === 4 && Math.hypot(x - fx, y - fy) + Math.hypot(tx - x, ty - y) < length + 1e-6);
    }
  }
});

test('packed lines are read as they were written', () => {
  // A coast of two points from 0.01° east, 0.02° north to 0.01° east, 0°, and a border from there to 0.03° east.
  const bytes = Uint8Array.of(8, 2, 4, 0, 3, 10, 0, 0, 4, 0);
  const origin = { longitude_deg: 0, latitude_deg: 0, height_m: 0 };
  const { coasts, borders } = unpackGround(bytes, origin, { least: [-9000, -9000, 0], most: [9000, 9000, 0] });
  const degree = (6378137 * Math.PI) / 180;
  const close = (found: number[], wanted: number[]): void => {
    assert.equal(found.length, wanted.length);
    found.forEach((metres, i) => assert.ok(Math.abs(metres - wanted[i]) < 0.01, found.join(', ')));
  };
  const northwards = (6335439.327 * Math.PI) / 180;
  close(coasts, [0.01 * degree, 0.02 * northwards, 0.01 * degree, 0]);
  close(borders, [0.01 * degree, 0, 0.03 * degree, 0]);
  assert.throws(() => unpackGround(bytes.subarray(0, 9), origin, { least: [0, 0, 0], most: [1, 1, 0] }), /damaged/);
});

test('the Earth is where it is: capes, and open sea', async () => {
  const { packedGround } = (await import(pathToFileURL('ground.mjs').href)) as { packedGround: () => Promise<{ base64: string }> };
  const { base64 } = await packedGround();
  assert.ok(base64.length < 120000, `${base64.length} characters`);
  const bytes = await inflate(bytesOfBase64(base64));
  const nearest_m = (longitude_deg: number, latitude_deg: number, kind: 'coasts' | 'borders'): number => {
    const ground = unpackGround(bytes, { longitude_deg, latitude_deg, height_m: 0 }, { least: [-60000, -60000, 0], most: [60000, 60000, 0] })[kind];
    let least = Infinity;
    for (let i = 0; i < ground.length; i += 4) {
      for (let share = 0; share <= 1; share += 0.1) {
        least = Math.min(least, Math.hypot(ground[i] + share * (ground[i + 2] - ground[i]), ground[i + 1] + share * (ground[i + 3] - ground[i + 1])));
      }
    }
    return least;
  };
  // Cape Roca, and Cape Byron.
  for (const [longitude, latitude] of [[-9.5, 38.78], [153.64, -28.64]] as const) {
    assert.ok(nearest_m(longitude, latitude, 'coasts') < 12000, `${longitude}, ${latitude}`);
  }
  // The bridge over the Rhine between Strasbourg and Kehl.
  assert.ok(nearest_m(7.8, 48.573, 'borders') < 8000);
  assert.equal(nearest_m(-30, -30, 'coasts'), Infinity);
  assert.equal(nearest_m(-30, -30, 'borders'), Infinity);
});
