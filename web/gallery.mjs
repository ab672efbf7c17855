// Photographs pages for the README and docs/gallery, in Chromium:
//
//   node gallery.mjs FOLDER_OF_PAGES FOLDER_OF_PICTURES
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [pages, pictures] = process.argv.slice(2);
const kPictures = [
  { page: 'bees', name: 'report-bees', theme: 'light', key: 'r' },
  { page: 'million', name: 'report-million', theme: 'dark', click: 'table tbody button', width: 1000, height: 640 },
  { page: 'flight', name: 'report-flight', theme: 'light', click: 'table tbody button' },
  { page: 'swap', name: 'report-swap', theme: 'light', click: 'table tbody button' },
  { page: 'fleet', name: 'report-fleet', theme: 'light', bee: '53', steps: 375 },
  { page: 'flight', name: 'report-phone', theme: 'dark', width: 390, height: 844 },
];

const browser = await chromium.launch({
  executablePath: process.env.BEESPACE_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
for (const { page: file, name, theme, click, key, bee, steps = 0, width = 1280, height = 800 } of kPictures) {
  const page = await browser.newPage({
    viewport: { width, height },
    colorScheme: theme,
    reducedMotion: 'reduce',
  });
  await page.goto(pathToFileURL(resolve(pages, `${file}.html`)).href);
  await page.waitForSelector('html[data-beespace="ready"]');
  if (key) await page.keyboard.press(key);
  if (click) await page.locator(click).first().click();
  if (bee) {
    // After so many steps from the beginning; then it flies there.
    await page.keyboard.press('Home');
    for (let step = 0; step < steps; ++step) await page.keyboard.press('.');
    await page.fill('#search', bee);
    await page.keyboard.press('Enter');
    await page.locator('#search').blur();
  }
  await page.waitForTimeout(500);
  await page.screenshot({ path: resolve(pictures, `${name}.png`) });
  await page.close();
}
await browser.close();
