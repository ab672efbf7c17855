// Metres east, north and up of an origin, and the place on the Earth that they mean.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { geographicOf } from '../../src/data/earth';
import type { Origin } from '../../src/data/page';

function close(found: Origin, longitude_deg: number, latitude_deg: number, height_m: number): void {
  assert.ok(Math.abs(found.longitude_deg - longitude_deg) < 1e-9, `longitude ${found.longitude_deg}, not ${longitude_deg}`);
  assert.ok(Math.abs(found.latitude_deg - latitude_deg) < 1e-9, `latitude ${found.latitude_deg}, not ${latitude_deg}`);
  assert.ok(Math.abs(found.height_m - height_m) < 1e-4, `height ${found.height_m}, not ${height_m}`);
}

test('the origin is itself, and up is up, everywhere', () => {
  for (const longitude_deg of [-179.9, -75.6, 0, 90, 180]) {
    for (const latitude_deg of [-89.9, -45, 0, 6.2, 89.9]) {
      for (const up of [-100, 0, 1500, 12000]) {
        close(geographicOf({ longitude_deg, latitude_deg, height_m: 20 }, [0, 0, up]), longitude_deg, latitude_deg, 20 + up);
      }
    }
  }
});

// The half axes of WGS84 are 6,378,137 m and 6,356,752.314245 m.
test('a quarter of the Earth away', () => {
  const equator: Origin = { longitude_deg: 0, latitude_deg: 0, height_m: 0 };
  close(geographicOf(equator, [6378137, 0, -6378137]), 90, 0, 0);
  close(geographicOf(equator, [0, 6356752.314245179, -6378137]), 0, 90, 0);
  close(geographicOf({ longitude_deg: 180, latitude_deg: 0, height_m: 0 }, [0, 1e6, -6378137]), 180, 90, 1e6 - 6356752.314245179);
});

test('across the day line', () => {
  const found = geographicOf({ longitude_deg: 179.9999, latitude_deg: 0, height_m: 0 }, [22.3, 0, 0]);
  assert.ok(found.longitude_deg < -179.9998, String(found.longitude_deg));
});
