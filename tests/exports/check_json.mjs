// Checks GeoJSON with check-geojson, and that GeoJSON and CZML have what the answers say:
//
//   node check_json.mjs FOLDER_OF_EXPORTS
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { exportsIn, pairsOf } from './answers.mjs';

const web = createRequire(new URL('../../web/package.json', import.meta.url));
const { check } = await import(pathToFileURL(web.resolve('@placemarkio/check-geojson')));
const [folder] = process.argv.slice(2);

/** Longitude and latitude, everywhere in a geometry. */
function positionsOf(coordinates) {
  return typeof coordinates[0] === 'number' ? [coordinates] : coordinates.flatMap(positionsOf);
}

function doubledArea(ring) {
  return ring.slice(1).reduce((sum, [x, y], i) => sum + ring[i][0] * y - x * ring[i][1], 0);
}

function checkGeometry({ type, coordinates }) {
  for (const [longitude, latitude, height] of positionsOf(coordinates)) {
    assert.ok(Math.abs(longitude) <= 180 && Math.abs(latitude) <= 90 && Number.isFinite(height));
  }
  const polygons = type === 'Polygon' ? [coordinates] : type === 'MultiPolygon' ? coordinates : [];
  for (const [ring] of polygons) assert.ok(doubledArea(ring) > 0, 'outlines go round counterclockwise');
}

/** With a vertical threshold two are told as they are when they are worst. */
function toldDistance({ closest_m, distance_m, worst_horizontal_m, worst_vertical_m }) {
  if (worst_horizontal_m !== undefined) return Math.hypot(worst_horizontal_m, worst_vertical_m);
  return closest_m ?? distance_m;
}

function checkGeojson(name, answer) {
  const { features } = check(readFileSync(join(folder, `${name}.geojson`), 'utf8'));
  features.forEach(({ geometry }) => checkGeometry(geometry));
  const of = (kind) => features.filter(({ properties }) => properties.kind === kind).map(({ properties }) => properties);
  const pairs = pairsOf(answer);
  assert.equal(of('pair').length, pairs.length);
  const distances = of('pair').map(({ closest_m, distance_m }) => closest_m ?? distance_m).sort((a, b) => a - b);
  const expected = pairs.map(toldDistance).sort((a, b) => a - b);
  distances.forEach((distance_m, i) => assert.ok(Math.abs(distance_m - expected[i]) <= 1e-12 * distance_m, `${distance_m} m, not ${expected[i]} m`));
  if (answer.conflicts) {
    assert.equal(of('conflict').length, pairs.length);
    assert.equal(new Set(of('path').map(({ id }) => id)).size, answer.input.bees);
    assert.equal(of('path').length, answer.input.bees + answer.gap_count);
  } else {
    assert.equal(of('at risk').length, answer.at_risk_count);
  }
  assert.equal(of('obstacle').length, name === 'show' ? 5 : 0);
  return `${features.length} features`;
}

function checkCzml(name, answer) {
  const [document, ...packets] = JSON.parse(readFileSync(join(folder, `${name}.czml`), 'utf8'));
  assert.equal(document.id, 'document');
  assert.equal(new Set(packets.map(({ id }) => id)).size, packets.length, 'ids are there once');
  const of = (kind) => packets.filter(({ id }) => id.startsWith(`${kind}/`)).length;
  assert.equal(of(answer.conflicts ? 'conflict' : 'pair'), pairsOf(answer).length);
  assert.equal(of('bee'), answer.conflicts ? answer.input.bees : answer.at_risk_count);
  assert.equal(of('obstacle'), name === 'show' ? 5 : 0);
  return `${packets.length} packets`;
}

for (const { name, answer } of exportsIn(folder)) {
  console.log(`${name}: GeoJSON with ${checkGeojson(name, answer)}, CZML with ${checkCzml(name, answer)}`);
}
