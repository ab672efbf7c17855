// How long pages take to their first frame, each opened so often in turn, so that what else the machine does hits all alike:
//
//   node first_frame.mjs TIMES PAGE...
//
// Prints the median and the least in milliseconds, and the median of the shares of the first page, opened just before or after.
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [times, ...pages] = process.argv.slice(2);
if (pages.length === 0) throw new Error('node first_frame.mjs TIMES PAGE...');

const browser = await chromium.launch({
  executablePath: process.env.BEESPACE_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});

async function firstFrame(file) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, colorScheme: 'dark', reducedMotion: 'reduce' });
  const page = await context.newPage();
  await page.goto(pathToFileURL(resolve(file)).href, { waitUntil: 'commit' });
  await page.waitForSelector('html[data-beespace="ready"]', { timeout: 120000 });
  const marks = await page.evaluate("performance.getEntriesByType('mark').map(({ name, startTime }) => [name, startTime])");
  await context.close();
  return Object.fromEntries(marks);
}

const median = (list) => list.slice().sort((a, b) => a - b)[Math.floor(list.length / 2)];
const taken = pages.map(() => []);
// The first opening of a browser is not counted.
await firstFrame(pages[0]);
for (let round = 0; round < Number(times); ++round) {
  // To and fro: none is always the first.
  const order = pages.map((_, i) => (round % 2 ? pages.length - 1 - i : i));
  for (const i of order) taken[i].push(await firstFrame(pages[i]));
}
await browser.close();
const first = (all) => all.map((marks) => marks['beespace: first frame']);
pages.forEach((page, i) => {
  const all = first(taken[i]);
  const shares = all.map((ms, round) => ms / first(taken[0])[round]);
  console.log(`${page}: median ${median(all).toFixed(0)} ms, least ${Math.min(...all).toFixed(0)} ms, share ${median(shares).toFixed(2)}`);
  if (process.env.BEESPACE_MARKS) {
    for (const name of Object.keys(taken[i][0])) console.log(`    ${name}: ${median(taken[i].map((marks) => marks[name])).toFixed(0)} ms`);
  }
});
