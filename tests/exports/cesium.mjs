// Opens exports with Cesium, in Chromium, and compares what Cesium made of them with the answers:
//
//   node cesium.mjs FOLDER_OF_EXPORTS
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { exportsIn, kBetween, pairsOf } from './answers.mjs';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const web = createRequire(here('../../web/package.json'));
const { build } = web('esbuild');
const { chromium } = web('playwright-core');
const [folder] = process.argv.slice(2);
const engine = here('node_modules/@cesium/engine');
const kHost = 'http://exports.invalid';
const kTypes = { '.js': 'text/javascript', '.json': 'application/json', '.wasm': 'application/wasm', '.html': 'text/html' };

/** Positions are written to a tenth of a millimetre, times to a microsecond. */
const kNear_m = 0.02;
const kNear_s = 0.002;

const bundled = await build({
  entryPoints: [here('cesium_page.mjs')],
  bundle: true,
  write: false,
  format: 'iife',
  globalName: 'exported',
  target: 'chrome110',
  external: ['http', 'https', 'fs', 'url', 'zlib'],
  loader: { '.wasm': 'dataurl' },
  logLevel: 'error',
});
const kPage =
  '<!doctype html><meta charset="utf-8"><style>html,body,#globe{margin:0;height:100%}' +
  '.cesium-credit-logoContainer,.cesium-widget-credits{display:none}#globe canvas{width:100%;height:100%}</style>' +
  `<div id="globe"></div><script>window.CESIUM_BASE_URL = '${kHost}/engine/';</script><script src="/page.js"></script>`;

const browser = await chromium.launch({
  executablePath: process.env.BEESPACE_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking'],
});
const page = await browser.newPage({ viewport: { width: 1200, height: 800 } });
page.setDefaultTimeout(120_000);
const complaints = [];
page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
// Nothing is asked of the network: what Cesium brings along is answered from its package.
await page.route('**/*', async (route) => {
  const { host, pathname } = new URL(route.request().url());
  if (host !== new URL(kHost).host) return route.abort();
  if (pathname === '/') return route.fulfill({ contentType: 'text/html', body: kPage });
  if (pathname === '/page.js') return route.fulfill({ contentType: 'text/javascript', body: bundled.outputFiles[0].text });
  const within = pathname.replace('/engine/', '');
  const file = [join(engine, 'Build', within), join(engine, 'Source', within)].find((path) => existsSync(path));
  if (!file) return route.fulfill({ status: 404, body: '' });
  return route.fulfill({ contentType: kTypes[extname(file)] ?? 'application/octet-stream', body: readFileSync(file) });
});
await page.goto(`${kHost}/`);

const call = (name, ...given) => page.evaluate(([what, values]) => window.exported[what](...values), [name, given]);
const apart = (a, b) => Math.hypot(...a.map((value, axis) => value - b[axis]));

function near(value, wanted, within, what) {
  assert.ok(Math.abs(value - wanted) <= within, `${what}: ${value} where ${wanted} is the answer`);
}

const distanceOf = ({ closest_m, distance_m }) => closest_m ?? distance_m;

/** Pairs that are where they are when they are closest, against their answers. */
async function checkPairs(ids, pairs) {
  const asked = pairs.map((pair) => ({ pair, what: pair.names.join(kBetween), both: pair.names.map((bee) => ids.get(bee)), time_s: pair.closest_s ?? 0 }));
  for (const { what, both } of asked) assert.ok(both[0] && both[1], `${what} are in the file`);
  const places = await call('placesOf', asked.flatMap(({ both, time_s }) => both.map((id) => [id, time_s])));
  for (const [i, { pair, what, time_s }] of asked.entries()) {
    const [a, b] = [places[2 * i], places[2 * i + 1]];
    assert.ok(a && b, `${what} are there at ${time_s}`);
    if (pair.horizontal_m === undefined) {
      near(apart(a.at, b.at), distanceOf(pair), kNear_m, `${what}, apart`);
    } else {
      // Of aircraft, between the places below them at height 0.
      near(apart(a.below, b.below), pair.horizontal_m, kNear_m, `${what}, horizontally`);
      near(Math.abs(a.height - b.height), pair.vertical_m, kNear_m, `${what}, in height`);
    }
  }
}

/** Ids of entities by the names of bees. */
function beesOf(entities, isBee) {
  return new Map(entities.filter(isBee).map(({ name, id }) => [name, id]));
}

function checkInterval([begins_s, ends_s], pair) {
  near(begins_s, pair.begins_s, kNear_s, `${pair.names.join(kBetween)}, begins`);
  near(ends_s, pair.ends_s, kNear_s, `${pair.names.join(kBetween)}, ends`);
}

async function checkCzml(name, answer, pairs) {
  const { entities, clock } = await call('load', `${name}.czml`, readFileSync(join(folder, `${name}.czml`), 'utf8'));
  const kind = (what) => entities.filter(({ id }) => id.startsWith(`${what}/`));
  const bees = beesOf(entities, ({ id }) => id.startsWith('bee/'));
  assert.equal(kind('bee').length, answer.conflicts ? answer.input.bees : answer.at_risk_count);
  for (const bee of kind('bee')) assert.equal(bee.label, bee.name, 'a bee has its name beside it');
  const lines = kind(answer.conflicts ? 'conflict' : 'pair');
  assert.equal(lines.length, pairs.length);
  await checkPairs(bees, pairs);
  const joined = pairs.map((pair) => {
    const line = lines.find(
      ({ name: of, intervals }) => of === pair.names.join(kBetween) && (pair.begins_s === undefined || Math.abs(intervals[0][0] - pair.begins_s) < kNear_s),
    );
    assert.ok(line, `${pair.names.join(kBetween)} is there`);
    if (answer.conflicts) checkInterval(line.intervals[0], pair);
    return { pair, line };
  });
  const lengths = await call('lengthsOf', joined.map(({ pair, line }) => [line.id, pair.closest_s ?? 0]));
  for (const [i, { pair, line }] of joined.entries()) {
    if (pair.horizontal_m === undefined) near(lengths[i], distanceOf(pair), kNear_m, line.name);
    else assert.ok(lengths[i] > distanceOf(pair), `${line.name} is joined by a line`);
  }
  if (answer.conflicts) await checkTimes(kind('bee'), clock);
  if (name === 'gap') await checkGap(entities);
  return `${entities.length} entities`;
}

/** Bees are there from their first to their last instant, and the clock goes over all of it. */
async function checkTimes(bees, clock) {
  const instants = bees.flatMap(({ intervals }) => intervals.flat());
  near(clock.begins_s, Math.min(...instants), kNear_s, 'the clock begins');
  near(clock.ends_s, Math.max(...instants), kNear_s, 'the clock ends');
  near(clock.current_s, clock.begins_s, kNear_s, 'the clock stands');
  const asked = bees.flatMap(({ id, intervals }) =>
    intervals.flatMap(([begins_s, ends_s]) =>
      // Dates of JavaScript are whole milliseconds.
      [begins_s, (begins_s + ends_s) / 2, ends_s].map((time_s) => [id, Math.min(Math.max(time_s, Math.ceil(begins_s * 1000) / 1000), Math.floor(ends_s * 1000) / 1000)]),
    ),
  );
  const places = await call('placesOf', asked);
  for (const [i, [id, time_s]] of asked.entries()) assert.ok(places[i], `${id} is somewhere at ${time_s}`);
}

/** Who is unknown for a while is nowhere then, and no path leads across. */
async function checkGap(entities) {
  const bee = entities.find(({ name, id }) => name === 'b' && id.startsWith('bee/'));
  assert.deepEqual(bee.intervals, [[0, 12], [18, 40]]);
  assert.deepEqual(await call('placesOf', [[bee.id, 15]]), [null]);
  assert.ok(!bee.has.includes('path'));
  assert.equal(entities.filter(({ id }) => id.startsWith('path/')).length, 2);
}

async function checkKml(name, answer, pairs) {
  const { entities } = await call('load', `${name}.kml`, readFileSync(join(folder, `${name}.kml`), 'utf8'));
  const within = (parent) => entities.filter((entity) => entity.parent === parent);
  const bees = within(answer.conflicts ? 'Paths' : 'At risk');
  assert.equal(bees.length, answer.conflicts ? answer.input.bees : answer.at_risk_count);
  const ids = beesOf(bees, () => true);
  const marks = within(answer.conflicts ? 'Conflicts' : 'Pairs too close');
  assert.equal(marks.length, pairs.length);
  await checkPairs(ids, pairs);
  if (answer.conflicts) {
    for (const [i, pair] of pairs.entries()) {
      assert.equal(marks[i].name, pair.names.join(kBetween));
      checkInterval(marks[i].intervals[0], pair);
    }
  }
  if (name === 'show') assert.equal(within('Obstacles').length, 5);
  return `${entities.length} entities`;
}

async function checkObstacles() {
  const heights = await call('heightsOf', [0, 1, 2, 3, 4].map((i) => `obstacle/${i}`));
  // The show stands at 130 m; what has no lower end is drawn a little below it.
  for (const [i, [low, high]] of [[null, 160], [130, 160], [130, 142], [150, 170], [145, 155]].entries()) {
    if (low !== null) near(heights[i][0], low, kNear_m, `obstacle ${i}, below`);
    near(heights[i][1], high, kNear_m, `obstacle ${i}, above`);
  }
}

for (const { name, answer } of exportsIn(folder)) {
  const pairs = pairsOf(answer);
  const kml = await checkKml(name, answer, pairs);
  const czml = await checkCzml(name, answer, pairs);
  if (name === 'show') await checkObstacles();
  console.log(`${name}: Cesium has ${kml} of its KML, ${czml} of its CZML, and ${pairs.length} pairs where the answer has them`);
}
await browser.close();
assert.deepEqual([...new Set(complaints)], []);
