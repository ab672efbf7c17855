// Photographs pages for the README and docs/gallery.md, in Chromium:
//
//   node gallery.mjs FOLDER_OF_PAGES FOLDER_OF_PICTURES
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [pages, pictures] = process.argv.slice(2);
const kPictures = [
  { page: 'bees', name: 'report-bees', theme: 'light', keys: [] },
  { page: 'million', name: 'report-million', theme: 'dark', keys: [] },
  { page: 'show', name: 'report-show', theme: 'light', keys: [] },
  { page: 'swap', name: 'report-swap', theme: 'light', keys: [] },
  { page: 'show', name: 'report-phone', theme: 'dark', keys: [], width: 390, height: 844 },
];

const browser = await chromium.launch({
  executablePath: process.env.BEESPACE_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
for (const { page: file, name, theme, keys, width = 1280, height = 800 } of kPictures) {
  const page = await browser.newPage({
    viewport: { width, height },
    colorScheme: theme,
    reducedMotion: 'reduce',
  });
  await page.goto(pathToFileURL(resolve(pages, `${file}.html`)).href);
  await page.waitForSelector('html[data-beespace="ready"]');
  // The worst is what one wants to see.
  await page.locator('table button, table a').first().click();
  for (const key of keys) await page.keyboard.press(key);
  await page.waitForTimeout(500);
  await page.screenshot({ path: resolve(pictures, `${name}.png`) });
  await page.close();
}
await browser.close();
