// Metres east and north of an origin along the ground, and the place on the Earth that they mean.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { geographicOf } from '../../src/data/earth';
import type { Origin } from '../../src/data/page';

function close(found: Origin, longitude_deg: number, latitude_deg: number, height_m: number): void {
  assert.ok(Math.abs(found.longitude_deg - longitude_deg) < 1e-9, `longitude ${found.longitude_deg}, not ${longitude_deg}`);
  assert.ok(Math.abs(found.latitude_deg - latitude_deg) < 1e-9, `latitude ${found.latitude_deg}, not ${latitude_deg}`);
  assert.equal(found.height_m, height_m);
}

test('the origin is itself, and a height is a height, everywhere', () => {
  for (const longitude_deg of [-179.9, -75.6, 0, 90, 180]) {
    for (const latitude_deg of [-89.9, -45, 0, 6.2, 89.9]) {
      for (const height of [-100, 0, 1500, 12000]) {
        close(geographicOf({ longitude_deg, latitude_deg, height_m: 0 }, [0, 0, height]), longitude_deg, latitude_deg, height);
      }
    }
  }
});

// The radii of curvature of WGS84 at the equator are 6,378,137 m along it and 6,335,439.327 m across it.
test('a quarter of the Earth away', () => {
  const equator: Origin = { longitude_deg: 0, latitude_deg: 0, height_m: 0 };
  const quarter = Math.PI / 2;
  close(geographicOf(equator, [6378137 * quarter, 0, 11582]), 90, 0, 11582);
  const north = geographicOf(equator, [0, 6335439.3272928 * quarter, 0]);
  assert.ok(Math.abs(north.latitude_deg - 90) < 1e-6, String(north.latitude_deg));
});

test('across the day line', () => {
  const found = geographicOf({ longitude_deg: 179.9999, latitude_deg: 0, height_m: 0 }, [22.3, 0, 0]);
  assert.ok(found.longitude_deg < -179.9998, String(found.longitude_deg));
});
