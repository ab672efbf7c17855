// How many frames a second a page shows while it plays: node playing.mjs SECONDS PAGE...
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [seconds, ...pages] = process.argv.slice(2);
if (pages.length === 0) throw new Error('node playing.mjs SECONDS PAGE...');
const browser = await chromium.launch({
  executablePath: process.env.BEESPACE_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
for (const file of pages) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'dark', reducedMotion: 'reduce' });
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForSelector('html[data-beespace="ready"]', { timeout: 120000 });
  await page.keyboard.press('r');
  await page.keyboard.press('Home');
  await page.keyboard.press(' ');
  // Every step of time is a frame; the first ones find out how many bees can be drawn.
  const steps = await page.evaluate(`new Promise((done) => {
    const times = [];
    new MutationObserver(() => times.push(performance.now())).observe(document.documentElement, { attributes: true, attributeFilter: ['data-time-s'] });
    setTimeout(() => done(times), 1000 * ${Number(seconds)});
  })`);
  const half = steps.slice(Math.floor(steps.length / 2));
  const rate = (list) => (list.length > 1 ? (1000 * (list.length - 1)) / (list[list.length - 1] - list[0]) : 0).toFixed(1);
  const said = await page.evaluate("[...document.querySelectorAll('.share-shown:not([hidden])')].map((one) => one.textContent).join('; ')");
  console.log(`${file}: ${rate(steps)} frames/s, in the second half ${rate(half)}${said ? ` (${said})` : ''}`);
  await page.close();
}
await browser.close();
