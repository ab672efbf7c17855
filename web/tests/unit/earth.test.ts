// Metres east and north of an origin along the ground, and the place on the Earth that they mean.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { geographicOf, mapped } from '../../src/data/earth';
import { measured } from '../../src/data/measure';
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

test('the map leads back to where it came from', () => {
  for (const [longitude_deg, latitude_deg] of [[0, 0], [8.5, 47.4], [-75.6, 6.2], [179.9, -60]] as const) {
    const origin = { longitude_deg, latitude_deg, height_m: 0 };
    for (const place of [[0, 0, 5], [1000, -2000, 0], [-300000, 800000, 11000], [4e6, 1e6, 0]] as const) {
      const back = mapped(origin, geographicOf(origin, [...place]));
      assert.ok(back.every((metres, axis) => Math.abs(metres - place[axis]) < 1e-5), back.join(', '));
    }
  }
});

test('what is measured: flat where there is no Earth, straight through the ground where there is one', () => {
  assert.deepEqual(measured([0, 0, 10], [30, 40, 130], undefined), { straight_m: 130, horizontal_m: 50, height_m: 120 });
  // On the equator, a quarter of the way around: a square's side of the circle's radius, whatever the map says.
  const equator: Origin = { longitude_deg: 0, latitude_deg: 0, height_m: 0 };
  const quarter = 6378137 * (Math.PI / 2);
  const { straight_m, horizontal_m, height_m } = measured([0, 0, 0], [quarter, 0, 0], equator);
  assert.ok(Math.abs(straight_m - 6378137 * Math.SQRT2) < 1e-3, String(straight_m));
  assert.ok(Math.abs(horizontal_m - straight_m) < 1e-6 && height_m === 0);
  // Upright, at any latitude: the height alone.
  const above = measured([0, 0, 100], [0, 0, 11100], { longitude_deg: 8, latitude_deg: 47, height_m: 0 });
  assert.ok(Math.abs(above.straight_m - 11000) < 1e-6 && above.horizontal_m < 1e-6 && above.height_m === 11000);
  // Higher up the same angle is farther apart; the ground below is not.
  const high = measured([0, 0, 12000], [100000, 0, 12000], equator);
  assert.ok(Math.abs(high.straight_m / high.horizontal_m - (1 + 12000 / 6378137)) < 1e-7);
});
