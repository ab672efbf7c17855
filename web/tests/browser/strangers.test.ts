// Names and notes of strangers are text, whatever they hold.
import assert from 'node:assert/strict';
import { pageTest } from './opened_page';

pageTest('hostile names are shown and never run', 'hostile', {}, async ({ page }) => {
  for (let i = 0; i < 6; ++i) await page.keyboard.press('n');
  for (const text of ['img', 'script', '{{', "'; window"]) {
    await page.locator('#search').fill(text);
    await page.waitForTimeout(30);
  }
  await page.locator('#search').fill('onerror');
  await page.keyboard.press('Enter');
  assert.match((await page.locator('.who-it-is').innerText()).toLowerCase(), /<img src=x onerror/);
  assert.equal(await page.evaluate(() => (window as { __pwned?: unknown }).__pwned), undefined);
  // Nothing but our own elements: no images, no links, two scripts that run: the guard and the loader.
  assert.equal(await page.locator('img, iframe, a, object, embed').count(), 0);
  assert.equal(await page.locator('script:not([type])').count(), 2);
});

pageTest('a long name neither clips nor widens the page', 'hostile', { width: 390, height: 844 }, async ({ page }) => {
  await page.locator('#search').fill('xxxxxxxx');
  await page.keyboard.press('Enter');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} pixels wide`);
});
